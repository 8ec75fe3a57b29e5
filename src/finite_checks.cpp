#include "finite_checks.hpp"

#include <floe/numeric/error.hpp>

#include <fmt/format.h>

#include <string>

namespace floe {
namespace {

template <typename Array>
void require(const Array& values, const std::string& name) {
  FLOE_VALIDATE_AS(
      ConvergenceError, values.allFinite(),
      "invalid " << name << ": not finite (must be; please report this with the case)");
}

}  // namespace

void require_finite(const FrequencyResult& result) {
  require(Eigen::Array2d(result.omega, result.wavenumber), "wavenumber");
  require(result.added_mass, "added mass");
  require(result.damping, "damping");
  require(result.exciting_force, "exciting force");
  require(result.amplitudes, "modal amplitudes");
  require(result.line_deflection, "deflection along lines");
  require(result.point_deflection, "deflection at points");
  for (const MatXcd& quantity : result.point_quantities) require(quantity, "quantity at points");
  require(result.wave_elevation, "elevation at wave points");
  for (const NodeField& field : result.fields) {
    require(field.deflection, "node field of the deflection");
    require(field.rotation_x, "node field of the rotation");
    require(field.rotation_y, "node field of the rotation");
    require(field.pressure, "node field of the pressure");
  }
}

void require_finite(const SeaTransfer& transfer) {
  const std::string place = fmt::format(" at omega = {} rad/s", transfer.omega);
  require(transfer.state, "transfer function" + place);
  for (const MatXcd& zone : transfer.zone_states)
    require(zone, "transfer function of a zone" + place);
}

}  // namespace floe
