#include "csv.hpp"
#include "expect.hpp"
#include "plates.hpp"

#include <floe/plate/dry_modes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace floe::plate {
namespace {

// ωa²√(m/D) of the free square Kirchhoff plate, Poisson 0.3, five digits (literature)
const std::vector<double> kSquareFactors{13.468, 19.596, 24.270, 34.801, 34.801, 61.093};

VecXd relative_errors(const VecXd& omega, const std::vector<double>& expected, Index first) {
  VecXd error(static_cast<Index>(expected.size()) - first);
  for (Index i = 0; i < error.size(); ++i) error[i] = omega[first + i] / expected[first + i] - 1.0;
  return error;
}

VecXd table1_errors(int nx, int ny) {
  const std::vector<double> expected =
      test::read_reference("table1_dry_modes_mindlin.csv").numbers("omega_rad_s");
  const DryModes modes =
      dry_modes(test::table1_mesh(nx, ny), test::table1_properties(), {.count = 20});
  return relative_errors(modes.omega, expected, 3);
}

void expect_square_factors(const mesh::Q8Mesh& mesh, double thickness, double tolerance) {
  const DryModes modes = dry_modes(mesh, test::unit_plate(thickness, 0.3), {.count = 9});
  for (int i = 0; i < 6; ++i)
    test::expect_close(modes.omega[3 + i], kSquareFactors[i], tolerance, 0.0,
                       "mode " + std::to_string(i + 4));
}

TEST(verification_DryModes, MatchTheTable1PlateAtElementsOf3m) {
  EXPECT_LT(table1_errors(100, 20).cwiseAbs().maxCoeff(), 0.00005);
}

TEST(verification_DryModes, MatchTheTable1PlateAtElementsOf6m) {
  EXPECT_LT(table1_errors(50, 10).cwiseAbs().maxCoeff(), 0.0002);
}

TEST(verification_DryModes, GiveThirtyOfTheTable1PlateInOrder) {
  const DryModes modes = dry_modes(test::table1_mesh(50, 10), test::table1_properties());
  ASSERT_EQ(modes.count(), 30);
  EXPECT_EQ(modes.rigid_count, 3);
  EXPECT_EQ(modes.omega.head(3).cwiseAbs().maxCoeff(), 0.0);
  for (int i = 3; i < 30; ++i) EXPECT_GT(modes.omega[i], modes.omega[i - 1]);
}

TEST(verification_DryModes, MatchTheFreeSquareKirchhoffPlate) {
  expect_square_factors(test::rectangle_arrays(20, 20, 1.0, 1.0).build(), 1e-3, 0.001);
}

TEST(verification_DryModes, DoNotLockOnElementsAThousandTimesAsWideAsThick) {
  expect_square_factors(test::rectangle_arrays(20, 20, 1.0, 1.0).build(), 5e-5, 0.0025);
}

// Corners moved by up to a fifth of an element; 0.01 for the modes on such elements, which is a
// fifth of the error of plain 2 × 2 shear
TEST(verification_DryModes, DoNotLockOnDistortedElementsEither) {
  expect_square_factors(test::distorted_rectangle(20, 20, 1.0, 1.0, 0.01).build(), 5e-5, 0.01);
}

// Euler–Bernoulli beam. The plate must lie below by no more than what rotary inertia and shear
// take, ½(kr)²(1 + E/κG) with r² = t²/12, and above by no more than the mesh's error (kh)⁴/480.
TEST(limit_DryModes, OfAStripAreThoseOfAFreeBeam) {
  const double length = 100.0;
  const PlateProperties properties{
      .thickness = 0.2, .youngs_modulus = 1e10, .poisson_ratio = 0.0, .density = 500.0};
  const DryModes modes =
      dry_modes(test::rectangle_arrays(50, 1, length, 2.0).build(), properties, {.count = 7});
  const std::array<double, 4> beta{4.730040745, 7.853204624, 10.995607838, 14.137165491};
  const double radius = properties.thickness / std::sqrt(12.0);
  for (int i = 0; i < 4; ++i) {
    const double k = beta[i] / length;
    const double beam = k * k * radius * std::sqrt(properties.youngs_modulus / properties.density);
    const double below = 0.5 * std::pow(k * radius, 2) * (1.0 + 2.0 / properties.shear_correction);
    const double above = std::pow(2.0 * k, 4) / 480.0;
    const double error = modes.omega[3 + i] / beam - 1.0;
    EXPECT_GT(error, -1.1 * below) << i;
    EXPECT_LT(error, 1.1 * above) << i;
  }
}

// Theory: fourth order where the mode is smooth. The edge layers of Mindlin's theory, thinner than
// the elements here, cost up to half an order (modes that twist).
TEST(order_DryModes, FrequenciesConvergeWithTheFourthOrder) {
  const std::array<double, 3> side{12.0, 6.0, 3.0};
  std::array<double, 3> bending{}, worst{};
  for (int level = 0; level < 3; ++level) {
    const VecXd error = table1_errors(25 << level, 5 << level).cwiseAbs();
    bending[level] = error[5];  // mode 9, a beam's third
    worst[level] = error.maxCoeff();
  }
  EXPECT_GT(test::observed_order(side, bending), 3.7);
  EXPECT_GT(test::observed_order(side, worst), 3.4);
}

// The estimate promises half to four and a half times the true error above 1e-3; below, down to
// 3e-5, a fifth to thirteen times
TEST(order_DryModes, EstimateTheErrorOfTheFrequencies) {
  const PlateProperties properties = test::table1_properties();
  const auto largest_error = [&](const DryModes& modes, const DryModes& fine) {
    return (modes.omega.tail(27).cwiseQuotient(fine.omega.tail(27)).array() - 1.0).abs().maxCoeff();
  };
  const auto check = [&](const mesh::Q8Mesh& mesh, const DryModes& fine, const std::string& what) {
    const DryModes modes = dry_modes(mesh, properties);
    const double error = largest_error(modes, fine);
    const double ratio = modes.estimated_frequency_error / error;
    EXPECT_GT(ratio, error > 1e-3 ? 0.5 : 0.2) << what << " error " << error;
    EXPECT_LT(ratio, error > 1e-3 ? 4.5 : 13.0) << what << " error " << error;
  };
  const DryModes rectangle = dry_modes(test::table1_mesh(150, 30), properties);
  for (const int nx : {25, 50, 75}) {
    check(test::table1_mesh(nx, nx / 5), rectangle, "rectangle " + std::to_string(nx));
    check(test::bent_rectangle(nx, nx / 5, 300.0, 60.0, 2.0).build(), rectangle,
          "bent rectangle " + std::to_string(nx));
  }
  const DryModes corner = dry_modes(test::l_shape(300.0, 100.0, 24).build(), properties);
  for (const int across : {5, 10})
    check(test::l_shape(300.0, 100.0, across).build(), corner, "L " + std::to_string(across));
  const DryModes ring = dry_modes(test::ring_arrays(90.0, 150.0, 96, 12).build(), properties);
  for (const int across : {3, 6})
    check(test::ring_arrays(90.0, 150.0, 8 * across, across).build(), ring,
          "ring " + std::to_string(across));
}

}  // namespace
}  // namespace floe::plate
