#include "bem/wave_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::bem {

double grid_step(const mesh::Q8Mesh& mesh, double wavenumber, double points_per_wavelength,
                 double least) {
  const double wanted = 2.0 * std::numbers::pi / (wavenumber * points_per_wavelength);
  const double nodes = std::sqrt(mesh.area() / double(mesh.node_count()));
  const double side = (mesh.upper() - mesh.lower()).minCoeff();
  // Rather a little finer than wanted, but never finer than allowed. Twice as fine as the nodes is:
  // bicubic interpolation between fewer than five points a wavelength costs the solver many steps
  const double floor = std::max(0.5 * nodes, least);
  const double cells = std::ceil(side / std::max(wanted, floor) - 1e-9);
  return std::max(side / std::max(1.0, cells), floor);
}

namespace {

// ν'' of (S.7): ν moved so that the wave along the plate decays as e^{-damping R/B}
Complex damped_flexural(const FloatingPlate& plate, const green::GreenFunction& green,
                        double shift) {
  const double k = plate.wavenumber, tanh = std::tanh(k * green.depth());
  const double cosh = std::cosh(std::min(k * green.depth(), 300.0));
  const double bending = plate.rigidity * std::pow(k, 4) - plate.inertia + 1.0;
  const double finite = std::isinf(green.depth()) ? 0.0 : k * green.depth() / (cosh * cosh);
  const double slope = (tanh + finite) * bending + 4.0 * plate.rigidity * std::pow(k, 4) * tanh;
  return {green.nu(), shift * slope};
}

}  // namespace

fmm::EvenSpectrum damped_wave_spectrum(const fmm::PaddedGrid& grid, double step,
                                       const green::GreenFunction& green, double width,
                                       const DampedWaveOptions& options) {
  const double unit_x = 2.0 * std::numbers::pi / (double(grid.padded_nx()) * step);
  const double unit_y = 2.0 * std::numbers::pi / (double(grid.padded_ny()) * step);
  const double floor = 0.5 * std::min(unit_x, unit_y);
  const Complex damped = green.nu() * Complex(1.0, options.damping / (green.wavenumber() * width));
  const FloatingPlate plate = options.plate.value_or(FloatingPlate{});
  const Complex flexural =
      options.plate ? damped_flexural(plate, green, options.damping / width) : Complex(0.0);
  return fmm::EvenSpectrum::from_symbol(grid, [&](Index mx, Index my) {
    const double mu = std::max(floor, std::hypot(unit_x * double(mx), unit_y * double(my)));
    const double tau = mu * std::tanh(mu * green.depth());
    if (!options.plate) return -damped / tau;
    const double bending = plate.rigidity * std::pow(mu, 4) - plate.inertia + 1.0;
    return (flexural - damped * bending) / (tau * bending - flexural);
  });
}

}  // namespace floe::bem
