#include "second_formula.hpp"
#include "test_paths.hpp"

#include <floe/green/green_function.hpp>
#include <floe/green/green_table.hpp>
#include <floe/numeric/error.hpp>

#include <csv.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace floe::green {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kExactTolerance = 1e-11;  // asked of the exact evaluation, relative to |G|
constexpr double kTableTolerance = 1e-10;  // asked of the table

double relative_error(Complex actual, Complex expected) {
  return std::abs(actual - expected) / std::abs(expected);
}

struct Reference {
  double nu, depth, distance;
  Complex value;
};

// Both reference tables, the finite depth as h = 1, the infinite one as ν = 1
std::vector<Reference> reference_values() {
  std::vector<Reference> values;
  const auto finite = test::read_csv(FLOE_TEST_DATA "/green_finite_depth.csv");
  const auto nu_h = finite.numbers("nu_h"), ratio = finite.numbers("R_over_h");
  const auto re = finite.numbers("re_hG"), im = finite.numbers("im_hG");
  for (std::size_t i = 0; i < nu_h.size(); ++i)
    values.push_back({nu_h[i], 1.0, ratio[i], {re[i], im[i]}});
  const auto infinite = test::read_csv(FLOE_TEST_DATA "/green_infinite_depth.csv");
  const auto nu_r = infinite.numbers("nu_R");
  const auto re_inf = infinite.numbers("re_G_over_nu"), im_inf = infinite.numbers("im_G_over_nu");
  for (std::size_t i = 0; i < nu_r.size(); ++i)
    values.push_back({1.0, kInfinity, nu_r[i], {re_inf[i], im_inf[i]}});
  return values;
}

TEST(verification_GreenFunction, AgreesWithBothReferenceTables) {
  const auto references = reference_values();
  ASSERT_GT(references.size(), 150u);
  for (const Reference& r : references)
    EXPECT_LE(relative_error(GreenFunction(r.nu, r.depth)(r.distance), r.value), kExactTolerance)
        << "nu=" << r.nu << " h=" << r.depth << " R=" << r.distance;
}

TEST(verification_GreenTable, AgreesWithBothReferenceTables) {
  const auto references = reference_values();
  double farthest = 0.0;
  for (const Reference& r : references) farthest = std::max(farthest, r.distance);
  std::map<std::pair<double, double>, std::unique_ptr<GreenTable>> tables;  // by ν and depth
  for (const Reference& r : references) {
    auto& table = tables[{r.nu, r.depth}];
    if (!table) table = std::make_unique<GreenTable>(GreenFunction(r.nu, r.depth), 1.7 * farthest);
    EXPECT_LT(table->min_distance(), r.distance);
    Complex value;
    table->evaluate({&r.distance, 1}, {&value, 1});
    EXPECT_LE(relative_error(value, r.value), kTableTolerance)
        << "nu=" << r.nu << " h=" << r.depth << " R=" << r.distance;
  }
}

struct RandomCase {
  double nu, distance;
};

// νh in 1e-6 … 1e3 and R/h in 1e-6 … 1e3, log-uniform, h = 1
std::vector<RandomCase> random_cases(int count) {
  std::mt19937 generator(20141);
  std::uniform_real_distribution<double> nu(-6.0, 3.0), distance(-6.0, 3.0);
  std::vector<RandomCase> cases;
  for (int i = 0; i < count; ++i) {
    const double exponent = nu(generator);
    cases.push_back({std::pow(10.0, exponent), std::pow(10.0, distance(generator))});
  }
  return cases;
}

TEST(twin_GreenFunction, EqualsTheRayIntegralAtRandomPoints) {
  for (const RandomCase& c : random_cases(1000)) {
    const GreenFunction green(c.nu, 1.0);
    const Complex value = green(c.distance);
    // The wave part is common to both formulas; its k is tested in Wavenumber, its H0 by the tables
    const Complex twin =
        value - green.remainder(c.distance) + test::remainder(c.nu, 1.0, c.distance);
    EXPECT_LE(relative_error(value, twin), kExactTolerance) << "nu=" << c.nu << " R=" << c.distance;
  }
}

TEST(twin_GreenTable, EqualsTheExactFunctionAtRandomPoints) {
  for (const RandomCase& c : random_cases(300)) {
    if (c.nu * c.distance > 1e3) continue;  // tables of many panels: HoldsItsTolerance … has them
    const GreenFunction green(c.nu, 1.0);
    const GreenTable table(green, 3.0 * c.distance);
    Complex value;
    table.evaluate({&c.distance, 1}, {&value, 1});
    EXPECT_LE(relative_error(value, green(c.distance)), kTableTolerance)
        << "nu=" << c.nu << " R=" << c.distance;
  }
}

TEST(twin_GreenTable, HoldsItsToleranceOverItsWholeRange) {
  for (const double depth : {0.02, 1.0, 50.0, kInfinity})
    for (const double nu : {1e-4, 0.1, 10.0, 250.0}) {
      const GreenTable table(GreenFunction(nu, depth), 200.0);
      EXPECT_LE(table.sampled_error(5000), kTableTolerance) << "nu=" << nu << " h=" << depth;
    }
}

TEST(GreenTable, IsExactOutsideItsRangeAndNeverNaN) {
  const GreenFunction green(0.1, 50.0);
  const GreenTable table(green, 100.0);
  const std::vector<double> distance{0.0, 1e-300, 1e-20, 99.0, 100.0, 101.0, 1e5};
  std::vector<Complex> value(distance.size());
  table.evaluate(distance, value);
  for (std::size_t i = 0; i < distance.size(); ++i) {
    EXPECT_FALSE(std::isnan(value[i].real()) || std::isnan(value[i].imag())) << distance[i];
    EXPECT_EQ(value[i], green(distance[i])) << distance[i];
  }
}

TEST(GreenFunction, IsNeverNaN) {
  for (double nu_h = 1e-9; nu_h < 1e6; nu_h *= 31.0)
    for (double distance = 1e-12; distance < 1e9; distance *= 17.0) {
      const Complex value = GreenFunction(nu_h, 1.0)(distance);
      EXPECT_TRUE(std::isfinite(value.real()) && std::isfinite(value.imag()))
          << "nu_h=" << nu_h << " R=" << distance;
    }
  EXPECT_TRUE(std::isinf(GreenFunction(1.0, 1.0)(0.0).real()));
  EXPECT_TRUE(std::isfinite(GreenFunction(1.0, 1.0)(0.0).imag()));
}

TEST(GreenFunction, RejectsWhatHasNoMeaning) {
  EXPECT_THROW(GreenFunction(0.0, 1.0), InputError);
  EXPECT_THROW(GreenFunction(1.0, -1.0), InputError);
  EXPECT_THROW(GreenFunction(1.0, std::nan("")), InputError);
  EXPECT_THROW(GreenFunction(1.0, 1.0)(-1.0), InputError);
  EXPECT_THROW(GreenFunction(1.0, 1.0)(std::nan("")), InputError);
}

TEST(limit_GreenFunction, TendsToTwoOverRNearTheSource) {
  // The next term is of the order ν ln νR: 1e-6 · 14 at νR = 1e-6
  for (const double depth : {0.1, 1.0, kInfinity})
    EXPECT_NEAR(GreenFunction(1e-3, depth)(1e-6).real() * 1e-6 / 2.0, 1.0, 2e-5 / depth + 1e-6);
}

TEST(limit_GreenFunction, TendsToInfiniteDepth) {
  // Deep water differs by terms of the order e^{-2νh} and (R/h)³/h: νh = 400, R/h = 1e-3
  const GreenFunction deep(1.0, 400.0), infinite(1.0, kInfinity);
  for (const double distance : {0.01, 0.1, 0.4})
    EXPECT_LE(relative_error(deep(distance), infinite(distance)), 1e-5);
}

TEST(identity_GreenFunction, IsASumOfItsWavePartAndTheRemainder) {
  const GreenFunction green(0.3, 4.0);
  for (const double distance : {0.1, 1.0, 10.0}) {
    const double x = green.wavenumber() * distance;
    const Complex wave = green.wave().coefficient * Complex(::j0(x), ::y0(x));
    EXPECT_LE(relative_error(wave + green.remainder(distance), green(distance)), 1e-14);
  }
}

}  // namespace
}  // namespace floe::green
