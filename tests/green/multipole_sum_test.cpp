// The multipole sum with the water's own kernel: error asked against error found, over depth,
// size in wavelengths, layout of the points and kind of charges.
#include <floe/fmm/direct_sum.hpp>
#include <floe/fmm/multipole_sum.hpp>
#include <floe/fmm/sampled_error.hpp>
#include <floe/green/green_table.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <ostream>
#include <random>
#include <tuple>

namespace floe::green {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Index kCount = 4000;

enum class Layout { kUniform, kClustered, kTwoGroups };

void PrintTo(Layout layout, std::ostream* out) {
  *out << (layout == Layout::kUniform     ? "uniform"
           : layout == Layout::kClustered ? "clustered"
                                          : "two groups");
}

// Points in a square of side 1
Points2 make_points(Layout layout, Index count) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform;
  Points2 points(2, count);
  for (Index i = 0; i < count; ++i) {
    Point2 p(uniform(random), uniform(random));
    if (layout == Layout::kClustered) {
      // Half of them gather at a corner, ever more densely
      const double radius = std::exp2(-12.0 * uniform(random));
      if (i % 2 == 0) p = Point2(0.3, 0.4) + 0.3 * radius * p;
    } else if (layout == Layout::kTwoGroups) {
      p = (i % 2 == 0 ? Point2(0.05 * p) : Point2(Point2(1.0, 0.9) - 0.05 * p));
    }
    points.col(i) = p;
  }
  return points;
}

// A random column and a smooth one, a plane wave that travels slowly
MatXcd make_charges(const Points2& points, double wavenumber) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  MatXcd charges(points.cols(), 2);
  for (Index i = 0; i < points.cols(); ++i) {
    charges(i, 0) = Complex(normal(random), normal(random));
    charges(i, 1) = std::polar(1.0, 0.3 * wavenumber * points(0, i)) * (1.0 + points(1, i));
  }
  return charges;
}

struct Errors {
  double random, smooth;
};

Errors errors_found(Layout layout, double kD, double kh, double tolerance) {
  const Points2 points = make_points(layout, kCount);
  const double nu = std::isinf(kh) ? kD : kD * std::tanh(kh);
  const auto plan = std::make_shared<const fmm::MultipolePlan>(points, points);
  const GreenTable kernel(GreenFunction(nu, kh / kD), plan->reach());
  const fmm::MultipoleSum sum(plan, kernel, tolerance, fmm::NearSums::kEvaluated);
  const MatXcd charges = make_charges(points, kD);
  MatXcd potentials(points.cols(), 2);
  sum.apply(charges, potentials);
  const fmm::DirectSum truth(points, points, kernel);
  return {fmm::sampled_error(truth, charges.leftCols(1), potentials.leftCols(1)),
          fmm::sampled_error(truth, charges.rightCols(1), potentials.rightCols(1))};
}

using Case = std::tuple<Layout, double, double, double>;

class MultipoleSum : public testing::TestWithParam<Case> {};
class MultipoleSumLong : public testing::TestWithParam<Case> {};

// From above the tolerance itself, from below two digits: a sum a hundred times more precise than
// asked would be one that takes too long. Random charges show it, smooth ones are summed better.
void expect_tolerance(const Case& values) {
  const auto [layout, kD, kh, tolerance] = values;
  const Errors errors = errors_found(layout, kD, kh, tolerance);
  EXPECT_LE(errors.random, tolerance);
  EXPECT_LE(errors.smooth, tolerance);
  EXPECT_GE(errors.random, 0.01 * tolerance);
}

TEST_P(MultipoleSum, MeetsItsToleranceAndDoesNotOverdoIt) { expect_tolerance(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    twin_Sweep, MultipoleSum,
    testing::Combine(testing::Values(Layout::kUniform, Layout::kClustered, Layout::kTwoGroups),
                     testing::Values(0.1, 5.0, 60.0), testing::Values(0.02, 1.0, kInfinity),
                     testing::Values(1e-2, 1e-4, 1e-6, 1e-9)));

TEST_P(MultipoleSumLong, MeetsItsToleranceAndDoesNotOverdoIt) { expect_tolerance(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    twin_ManyWaves, MultipoleSumLong,
    testing::Combine(testing::Values(Layout::kUniform, Layout::kClustered, Layout::kTwoGroups),
                     testing::Values(500.0), testing::Values(0.02, 1.0, kInfinity),
                     testing::Values(1e-2, 1e-4, 1e-6)));

}  // namespace
}  // namespace floe::green
