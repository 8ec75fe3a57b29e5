#pragma once

#include <benchmark/benchmark.h>
#include <omp.h>

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>

/// How a measurement reaches Google Benchmark: one iteration that alternates with its anchor by
/// itself, and tells its medians.
namespace floe::bench {

struct Figures {
  double nodes = 0.0;
  double tolerance = 0.0;  ///< asked; 0: exact
  double seconds = 0.0;    ///< median; CPU time unless the name says wall
  double anchor = 0.0;     ///< the anchor's median in the same run [s]; 0: none
  double error = 0.0;      ///< measured against the truth named in the program
  double bytes = 0.0;      ///< held
  std::map<std::string, double> more;
};

/// Registers a measurement. Names that end in "/full" are left out of the short set.
inline void add_measurement(const std::string& name, const std::function<Figures()>& measure) {
  ::benchmark::RegisterBenchmark(name.c_str(),
                                 [measure](::benchmark::State& state) {
                                   Figures f;
                                   for ([[maybe_unused]] auto _ : state) {
                                     f = measure();
                                     state.SetIterationTime(f.seconds);
                                   }
                                   state.counters["N"] = f.nodes;
                                   state.counters["threads"] = omp_get_max_threads();
                                   state.counters["tolerance"] = f.tolerance;
                                   state.counters["error"] = f.error;
                                   state.counters["bytes"] = f.bytes;
                                   if (f.anchor > 0.0) {
                                     state.counters["anchor_s"] = f.anchor;
                                     state.counters["ratio"] = f.seconds / f.anchor;
                                   }
                                   for (const auto& [key, value] : f.more)
                                     state.counters[key] = value;
                                 })
      ->Iterations(1)
      ->UseManualTime()
      ->Unit(::benchmark::kMillisecond);
}

/// Runs what was registered; Google Benchmark's flags choose and format.
inline int run_measurements(int argc, char** argv) {
  ::benchmark::Initialize(&argc, argv);
  if (::benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  ::benchmark::RunSpecifiedBenchmarks();
  ::benchmark::Shutdown();
  return 0;
}

}  // namespace floe::bench
