// Time, memory and error of the dry modes of the paper's plate (Table 1), 30 modes.
//   benchmark_dry_modes [NX…]    elements along the plate, multiples of 5, rising; default 100 to
//   705
// One line a mesh. Peak memory is that of the process so far.
#include "csv.hpp"

#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/memory.hpp>
#include <floe/plate/dry_modes.hpp>

#include <omp.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
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

void run(int nx) {
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
  std::printf("%8ld | %8.2f | %8.2f | %8.2f | %8.2f | %8.2f | %8.0f | %8.0f | %5ld | %.1e | %.1e\n",
              static_cast<long>(mesh.node_count()), report.assembly_seconds, report.factor_seconds,
              report.iteration_seconds, wall, processor_seconds() - processor_start,
              8e-6 * static_cast<double>(report.factor_entries),
              1e-6 * floe::numeric::peak_memory(), static_cast<long>(report.solve_count),
              largest_error(modes), modes.estimated_frequency_error);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<int> sizes;
  for (int i = 1; i < argc; ++i) sizes.push_back(std::atoi(argv[i]));
  if (sizes.empty()) sizes = {100, 200, 405, 705};
  std::printf("plate of Table 1, 30 modes, tolerance 1e-10, %d threads\n", omp_get_max_threads());
  std::printf(
      "   nodes | assemble |   factor |  Lanczos |   wall s |    CPU s | factor MB | peak MB "
      "| solves | error | estimate of 30\n");
  try {
    for (const int nx : sizes) run(nx);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "benchmark_dry_modes: error: %s\n", error.what());
    return 1;
  }
}
