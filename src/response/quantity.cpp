#include <floe/response/quantity.hpp>

#include <array>
#include <utility>

namespace floe::response {
namespace {

constexpr std::array<std::pair<Quantity, std::string_view>, 14> kNames{{
    {Quantity::kDeflection, "deflection"},
    {Quantity::kVelocity, "velocity"},
    {Quantity::kAcceleration, "acceleration"},
    {Quantity::kSlopeX, "slope_x"},
    {Quantity::kSlopeY, "slope_y"},
    {Quantity::kBendingMomentX, "bending_moment_x"},
    {Quantity::kBendingMomentY, "bending_moment_y"},
    {Quantity::kTwistingMoment, "twisting_moment"},
    {Quantity::kShearForceX, "shear_force_x"},
    {Quantity::kShearForceY, "shear_force_y"},
    {Quantity::kSurfaceStressX, "surface_stress_x"},
    {Quantity::kSurfaceStressY, "surface_stress_y"},
    {Quantity::kPressure, "pressure"},
    {Quantity::kRelativeElevation, "relative_elevation"},
}};

}  // namespace

std::string_view name(Quantity quantity) {
  for (const auto& [value, text] : kNames)
    if (value == quantity) return text;
  return "";
}

std::optional<Quantity> quantity_from_name(std::string_view name) {
  for (const auto& [value, text] : kNames)
    if (text == name) return value;
  return std::nullopt;
}

const std::vector<Quantity>& all_quantities() {
  static const std::vector<Quantity> all = [] {
    std::vector<Quantity> values;
    for (const auto& entry : kNames) values.push_back(entry.first);
    return values;
  }();
  return all;
}

}  // namespace floe::response
