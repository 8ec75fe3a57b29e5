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

fmm::EvenSpectrum damped_wave_spectrum(const fmm::PaddedGrid& grid, double step,
                                       const green::GreenFunction& green, double width,
                                       double damping) {
  const double unit_x = 2.0 * std::numbers::pi / (double(grid.padded_nx()) * step);
  const double unit_y = 2.0 * std::numbers::pi / (double(grid.padded_ny()) * step);
  const double floor = 0.5 * std::min(unit_x, unit_y);
  const Complex damped = green.nu() * Complex(1.0, damping / (green.wavenumber() * width));
  return fmm::EvenSpectrum::from_symbol(grid, [&](Index mx, Index my) {
    const double mu = std::max(floor, std::hypot(unit_x * double(mx), unit_y * double(my)));
    return -damped / (mu * std::tanh(mu * green.depth()));
  });
}

}  // namespace floe::bem
