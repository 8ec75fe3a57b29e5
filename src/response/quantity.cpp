#include <floe/response/quantity.hpp>

#include <algorithm>
#include <array>

namespace floe::response {
namespace {

struct Entry {
  Quantity quantity;
  std::string_view name, label, unit, unit_per_metre;
};

constexpr std::array<Entry, 14> kEntries{{
    {Quantity::kDeflection, "deflection", "deflection w", "m", "m/m"},
    {Quantity::kVelocity, "velocity", "vertical velocity", "m/s", "m/s per m"},
    {Quantity::kAcceleration, "acceleration", "vertical acceleration", "m/s²", "m/s² per m"},
    {Quantity::kSlopeX, "slope_x", "slope ∂w/∂x", "rad", "rad per m"},
    {Quantity::kSlopeY, "slope_y", "slope ∂w/∂y", "rad", "rad per m"},
    {Quantity::kBendingMomentX, "bending_moment_x", "bending moment Mx", "N m/m", "N m/m per m"},
    {Quantity::kBendingMomentY, "bending_moment_y", "bending moment My", "N m/m", "N m/m per m"},
    {Quantity::kTwistingMoment, "twisting_moment", "twisting moment Mxy", "N m/m", "N m/m per m"},
    {Quantity::kShearForceX, "shear_force_x", "shear force Qx", "N/m", "N/m per m"},
    {Quantity::kShearForceY, "shear_force_y", "shear force Qy", "N/m", "N/m per m"},
    {Quantity::kSurfaceStressX, "surface_stress_x", "stress σxx, upper side", "Pa", "Pa per m"},
    {Quantity::kSurfaceStressY, "surface_stress_y", "stress σyy, upper side", "Pa", "Pa per m"},
    {Quantity::kPressure, "pressure", "pressure", "Pa", "Pa per m"},
    {Quantity::kRelativeElevation, "relative_elevation", "relative elevation", "m", "m/m"},
}};

const Entry& entry(Quantity quantity) {
  return *std::find_if(kEntries.begin(), kEntries.end(),
                       [&](const Entry& entry) { return entry.quantity == quantity; });
}

}  // namespace

std::string_view name(Quantity quantity) { return entry(quantity).name; }

std::string_view label(Quantity quantity) { return entry(quantity).label; }

std::string_view unit(Quantity quantity) { return entry(quantity).unit; }

std::string_view unit_per_metre(Quantity quantity) { return entry(quantity).unit_per_metre; }

std::optional<Quantity> quantity_from_name(std::string_view name) {
  for (const Entry& entry : kEntries)
    if (entry.name == name) return entry.quantity;
  return std::nullopt;
}

const std::vector<Quantity>& all_quantities() {
  static const std::vector<Quantity> all = [] {
    std::vector<Quantity> values;
    for (const Entry& entry : kEntries) values.push_back(entry.quantity);
    return values;
  }();
  return all;
}

bool is_structural(Quantity quantity) {
  return quantity != Quantity::kPressure && quantity != Quantity::kRelativeElevation;
}

bool is_section_force(Quantity quantity) {
  return quantity >= Quantity::kBendingMomentX && quantity <= Quantity::kSurfaceStressY;
}

}  // namespace floe::response
