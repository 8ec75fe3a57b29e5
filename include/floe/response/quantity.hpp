#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace floe::response {

/// What can be asked for at points, per metre of wave amplitude.
enum class Quantity {
  kDeflection,        ///< w (R.1) [m]
  kVelocity,          ///< -iωw [m/s]
  kAcceleration,      ///< -ω²w [m/s²]
  kSlopeX,            ///< ∂w/∂x [-]
  kSlopeY,            ///< ∂w/∂y [-]
  kBendingMomentX,    ///< ∫ z σxx dz [N m/m]
  kBendingMomentY,    ///< ∫ z σyy dz [N m/m]
  kTwistingMoment,    ///< ∫ z σxy dz [N m/m]
  kShearForceX,       ///< [N/m]
  kShearForceY,       ///< [N/m]
  kSurfaceStressX,    ///< σxx at z = +thickness/2 (R.2) [Pa]
  kSurfaceStressY,    ///< σyy at z = +thickness/2 [Pa]
  kPressure,          ///< total pressure p on the underside (R.3) [Pa]
  kRelativeElevation  ///< p/ρg [m]
};

/// Name as in case and result files: "deflection", "bending_moment_x", …
std::string_view name(Quantity quantity);

/// In words: "deflection", "bending moment Mx", …
std::string_view label(Quantity quantity);

/// Unit of the quantity itself ("m", "N m/m") and per metre of wave amplitude ("m/m", "N m/m per
/// m").
std::string_view unit(Quantity quantity);
std::string_view unit_per_metre(Quantity quantity);

/// The quantity of that name, or nothing.
std::optional<Quantity> quantity_from_name(std::string_view name);

/// All of them, in the order above.
const std::vector<Quantity>& all_quantities();

/// Whether a quantity follows from the displacement alone; pressure and relative elevation do not.
bool is_structural(Quantity quantity);

/// Whether it is a moment, a shear force or a stress: those profit from the static correction.
bool is_section_force(Quantity quantity);

}  // namespace floe::response
