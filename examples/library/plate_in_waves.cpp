// How far do the two ends of a floating plate move in head waves? A program on the library of floe:
// a case goes in, results come out in memory. docs/howto/library.md explains it.
#include <floe/numeric/error.hpp>
#include <floe/run_results.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>

int main() {
  // Describe water, plate and waves, in SI units
  floe::Case data;
  data.water = {.depth = 58.5, .density = 1025.0, .gravity = 9.81};
  data.plate = {
      .thickness = 2.0, .youngs_modulus = 1.19e10, .poisson_ratio = 0.13, .density = 256.25};
  data.mesh = floe::mesh::RectangleOptions{.length = 300.0, .width = 60.0, .nx = 50, .ny = 10};
  data.omega = {0.42, 0.72, 1.01};
  data.heading_deg = {0.0};
  data.points = {{"weather", {-150.0, -30.0}}, {"lee", {150.0, -30.0}}};

  try {
    // Solve plate and water together
    const floe::RunResults results = floe::analyse(data);
    for (const std::string& warning : results.warnings)
      std::fprintf(stderr, "warning: %s\n", warning.c_str());

    // Print amplitudes per metre of wave
    std::printf("omega [rad/s]  wavelength [m]  weather end [m/m]  lee end [m/m]\n");
    for (const floe::FrequencyResult& wave : results.frequencies)
      std::printf("%13.2f %15.1f %18.4f %14.4f\n", wave.omega,
                  2.0 * std::numbers::pi / wave.wavenumber, std::abs(wave.point_deflection(0, 0)),
                  std::abs(wave.point_deflection(1, 0)));
  } catch (const floe::Error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
