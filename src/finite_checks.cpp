#include "finite_checks.hpp"

#include <floe/numeric/error.hpp>

#include <string>

namespace floe {
namespace {

template <typename Array>
void require(const Array& values, const std::string& name, double omega) {
  FLOE_VALIDATE_AS(ConvergenceError, values.allFinite(),
                   "invalid " << name << " at omega = " << omega
                              << " rad/s: not finite (must be; please report this with the case)");
}

}  // namespace

void require_finite(const FrequencyResult& result) {
  const double omega = result.omega;
  require(Eigen::Array2d(omega, result.wavenumber), "wavenumber", omega);
  require(result.added_mass, "added mass", omega);
  require(result.damping, "damping", omega);
  require(result.exciting_force, "exciting force", omega);
  require(result.amplitudes, "modal amplitudes", omega);
  require(result.line_deflection, "deflection along lines", omega);
  require(result.point_deflection, "deflection at points", omega);
  for (const MatXcd& quantity : result.point_quantities)
    require(quantity, "quantity at points", omega);
  require(result.wave_elevation, "elevation at wave points", omega);
  for (const NodeField& field : result.fields) {
    require(field.deflection, "node field of the deflection", omega);
    require(field.rotation_x, "node field of the rotation", omega);
    require(field.rotation_y, "node field of the rotation", omega);
    require(field.pressure, "node field of the pressure", omega);
  }
}

void require_finite(const SeaTransfer& transfer) {
  require(transfer.state, "transfer function", transfer.omega);
  for (const MatXcd& zone : transfer.zone_states)
    require(zone, "transfer function of a zone", transfer.omega);
}

}  // namespace floe
