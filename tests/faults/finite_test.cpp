#include "fabricated_results.hpp"
#include "finite_checks.hpp"
#include "second_try.hpp"

#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace floe {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string complaint(const std::function<void(FrequencyResult&)>& spoil) {
  FrequencyResult result = test::small_result(0.4);
  spoil(result);
  try {
    require_finite(result);
  } catch (const ConvergenceError& error) {
    return error.what();
  }
  return "";
}

TEST(Finite, NamesTheArray) {
  using Result = FrequencyResult;
  EXPECT_EQ(complaint([](Result&) {}), "");
  const std::pair<const char*, std::function<void(Result&)>> table[] = {
      {"wavenumber", [](Result& r) { r.wavenumber = kInfinity; }},
      {"added mass", [](Result& r) { r.added_mass(1, 2) = kNan; }},
      {"damping", [](Result& r) { r.damping(3, 3) = -kInfinity; }},
      {"exciting force",
       [](Result& r) {
         r.exciting_force(0, 1) = {0.0, kNan};
       }},
      {"modal amplitudes",
       [](Result& r) {
         r.amplitudes(2, 0) = {kInfinity, 0.0};
       }},
      {"deflection along lines", [](Result& r) { r.line_deflection(4, 1) = kNan; }},
      {"deflection at points", [](Result& r) { r.point_deflection(1, 1) = kNan; }},
      {"quantity at points", [](Result& r) { r.point_quantities[1](0, 0) = kNan; }},
      {"elevation at wave points", [](Result& r) { r.wave_elevation(0, 0) = kNan; }},
      {"node field of the pressure", [](Result& r) { r.fields[0].pressure(3) = kNan; }},
  };
  for (const auto& [name, spoil] : table)
    EXPECT_EQ(complaint(spoil), std::string("invalid ") + name +
                                    ": not finite (must be; please report this with the case)");
}

TEST(Finite, HoldsForTheStatesOfSeas) {
  SeaTransfer transfer{0.5, MatXcd::Ones(3, 4)};
  EXPECT_NO_THROW(require_finite(transfer));
  transfer.state(2, 3) = kNan;
  try {
    require_finite(transfer);
    FAIL() << "not refused";
  } catch (const ConvergenceError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("transfer function at omega = 0.5 rad/s: not"));
  }
}

TEST(ThrowAtFrequency, TellsItAndWhereTheMeshIsCoarse) {
  const mesh::Q8Mesh mesh = mesh::make_rectangle(
      {.length = 60.0, .width = 12.0, .nx = 20, .ny = 4});  // nodes 1.5 m apart
  const auto message = [&](double omega) -> std::string {
    try {
      throw_at_frequency(ConvergenceError("it failed"), omega, Case{}, mesh);
    } catch (const ConvergenceError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(0.5), "omega = 0.5 rad/s: it failed");
  // 2 π 9.81 / 4² = 3.852 m
  EXPECT_EQ(message(4.0),
            "omega = 4 rad/s: it failed; the mesh has 2.6 nodes per wavelength (refine it, 6 are "
            "enough)");
}

}  // namespace
}  // namespace floe
