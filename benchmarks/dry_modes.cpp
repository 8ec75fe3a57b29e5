// Time, memory and error of the dry modes of the paper's plate (Table 1), 30 modes.
// The bytes are the peak of the process so far; the error is that of the first 20 frequencies.
#include "csv.hpp"
#include "figures.hpp"

#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/memory.hpp>
#include <floe/plate/dry_modes.hpp>

#include <omp.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

namespace {

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

// The largest relative error of the first 20 frequencies
double largest_error(const floe::plate::DryModes& modes) {
  const std::vector<double> expected =
      floe::test::read_reference("table1_dry_modes_mindlin.csv").numbers("omega_rad_s");
  double largest = 0.0;
  for (std::size_t i = 3; i < expected.size(); ++i)
    largest = std::max(largest, std::abs(modes.omega[static_cast<long>(i)] / expected[i] - 1.0));
  return largest;
}

floe::bench::Figures run(int nx) {
  const floe::mesh::Q8Mesh mesh =
      floe::mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = nx, .ny = nx / 5});
  const floe::plate::PlateProperties properties{
      .thickness = 2.0, .youngs_modulus = 1.19e10, .poisson_ratio = 0.13, .density = 256.25};
  const double processor_start = processor_seconds();
  const auto start = std::chrono::steady_clock::now();
  const floe::plate::DryModes modes = floe::plate::dry_modes(mesh, properties);
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const floe::plate::DryModeReport& report = modes.report;
  return {.nodes = static_cast<double>(mesh.node_count()),
          .tolerance = 1e-10,
          .seconds = processor_seconds() - processor_start,
          .error = largest_error(modes),
          .bytes = floe::numeric::peak_memory(),
          .more = {{"wall_s", wall},
                   {"assembly_s", report.assembly_seconds},
                   {"factor_s", report.factor_seconds},
                   {"iteration_s", report.iteration_seconds},
                   {"factor_bytes", 8.0 * static_cast<double>(report.factor_entries)},
                   {"solves", static_cast<double>(report.solve_count)},
                   {"estimated_error", modes.estimated_frequency_error}}};
}

}  // namespace

int main(int argc, char** argv) {
  for (const int nx : {100, 200, 405, 705})
    floe::bench::add_measurement("dry_modes/nx=" + std::to_string(nx) + (nx > 250 ? "/full" : ""),
                                 [=] { return run(nx); });
  return floe::bench::run_measurements(argc, argv);
}
