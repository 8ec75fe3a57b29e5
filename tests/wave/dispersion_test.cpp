#include <floe/numeric/error.hpp>
#include <floe/wave/dispersion.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace floe::wave {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// kh tanh kh / νh - 1, in extended precision; a relative error e of k gives at most 2e
double residual(double k, double nu, double depth) {
  const long double kh = static_cast<long double>(k) * depth;
  return static_cast<double>(kh * std::tanh(kh) / (static_cast<long double>(nu) * depth) - 1.0L);
}

TEST(Wavenumber, SatisfiesTheDispersionRelationFromShallowToDeepWater) {
  for (double kh = 1e-3; kh < 1.1e3; kh *= 1.3) {
    const Water water{.depth = 20.0, .gravity = 9.81};
    const double omega = angular_frequency(kh / water.depth, water);
    const double k = wavenumber(omega, water);
    EXPECT_NEAR(residual(k, omega * omega / water.gravity, water.depth), 0.0, 1e-15) << "kh=" << kh;
    EXPECT_NEAR(k * water.depth / kh, 1.0, 1e-14) << "kh=" << kh;
  }
}

TEST(Wavenumber, OfInfiniteDepthIsOmegaSquaredOverGravity) {
  EXPECT_DOUBLE_EQ(wavenumber(0.7, {.depth = kInfinity}), 0.7 * 0.7 / 9.81);
}

TEST(limit_Wavenumber, TendsToDeepAndToShallowWater) {
  // tanh kh = 1 - 2e^{-2kh} …, so kh = 20 is deep to rounding
  EXPECT_NEAR(wavenumber(1.0, {.depth = 200.0}) * 9.81, 1.0, 1e-15);
  // kh tanh kh = (kh)² (1 - (kh)²/3 …): k = ω/√(gh) to (kh)²/6
  const Water shallow{.depth = 1e-3};
  const double kh = 0.01 / std::sqrt(9.81 * 1e-3) * 1e-3;
  EXPECT_NEAR(wavenumber(0.01, shallow) * std::sqrt(9.81 * 1e-3) / 0.01, 1.0,
              kh * kh / 6.0 + 1e-15);
}

TEST(Wavenumber, RejectsWhatIsNotPositive) {
  EXPECT_THROW(wavenumber(0.0, {.depth = 10.0}), InputError);
  EXPECT_THROW(wavenumber(-1.0, {.depth = 10.0}), InputError);
  EXPECT_THROW(wavenumber(kInfinity, {.depth = 10.0}), InputError);
  EXPECT_THROW(wavenumber(std::nan(""), {.depth = 10.0}), InputError);
  EXPECT_THROW(wavenumber(1.0, {.depth = 0.0}), InputError);
  EXPECT_THROW(wavenumber(1.0, {.depth = 10.0, .gravity = 0.0}), InputError);
}

TEST(EvanescentWavenumber, IsTheRootInItsInterval) {
  for (double nu_h = 1e-6; nu_h < 2e3; nu_h *= 5.0)
    for (const int n : {1, 2, 3, 10, 100, 1000}) {
      const double x = evanescent_wavenumber(n, nu_h / 5.0, 5.0) * 5.0;
      const double target = n * std::numbers::pi;
      EXPECT_GT(x, target - 0.5 * std::numbers::pi);
      EXPECT_LE(x, target);
      // x = nπ - atan(νh/x), the same equation without the pole of tan
      EXPECT_NEAR((x + std::atan(nu_h / x)) / target, 1.0, 1e-15) << "nu_h=" << nu_h << " n=" << n;
    }
}

TEST(GroupVelocity, IsTheSlopeOfTheDispersionRelation) {
  for (const double depth : {0.5, 58.5, 1e4}) {
    const Water water{.depth = depth};
    for (const double omega : {0.1, 0.5, 2.0}) {
      const double k = wavenumber(omega, water), step = 1e-4 * k;
      const double slope =
          (angular_frequency(k + step, water) - angular_frequency(k - step, water)) / (2.0 * step);
      // Central difference: relative error of the order of (step/k)²
      EXPECT_NEAR(group_velocity(omega, water) / slope, 1.0, 1e-7);
    }
  }
}

TEST(AngularFrequency, InvertsTheWavenumber) {
  for (const double depth : {0.5, 58.5, kInfinity}) {
    const Water water{.depth = depth};
    for (double omega = 0.05; omega < 10.0; omega *= 1.7)
      EXPECT_NEAR(angular_frequency(wavenumber(omega, water), water) / omega, 1.0, 1e-14);
  }
}

}  // namespace
}  // namespace floe::wave
