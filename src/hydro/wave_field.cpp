#include <floe/hydro/wave_field.hpp>
#include <floe/numeric/error.hpp>

#include <numbers>

namespace floe::hydro {
namespace {

// κ/ρg, the factor of the pressure integral
double pressure_factor(const green::GreenFunction& green, const wave::Water& water) {
  return green.nu() / (4.0 * std::numbers::pi) / (water.density * water.gravity);
}

}  // namespace

MatXcd wave_elevation(const bem::ElementIntegrals& integrals, const green::GreenTable& green,
                      const wave::Water& water, const Points2& points,
                      const Eigen::Ref<const MatXcd>& incident,
                      const Eigen::Ref<const MatXcd>& total_pressure) {
  FLOE_EXPECT(incident.rows() == points.cols() && incident.cols() == total_pressure.cols());
  const double factor = pressure_factor(green.exact(), water);
  MatXcd elevation = incident;
#pragma omp parallel for schedule(dynamic, 1)
  for (Index i = 0; i < points.cols(); ++i) {
    VecXcd row(integrals.mesh().node_count());
    integrals.point_row(points.col(i), green, row);
    elevation.row(i) -= factor * (row.transpose() * total_pressure);
  }
  return elevation;
}

MatXcd far_field_amplitude(const green::GreenFunction& green, const wave::Water& water,
                           const MatXcd& wave_loads_reversed, const MatXcd& total_pressure) {
  const Complex factor = -pressure_factor(green, water) * green.wave().coefficient;
  return factor * (wave_loads_reversed.transpose() * total_pressure);
}

}  // namespace floe::hydro
