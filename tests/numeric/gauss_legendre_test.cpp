#include <floe/numeric/error.hpp>
#include <floe/numeric/gauss_legendre.hpp>

#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace floe::numeric {
namespace {

// ∫ x^degree dx over [-1, 1] by the rule
double moment(const QuadratureRule& rule, int degree) {
  double sum = 0.0;
  for (std::size_t i = 0; i < rule.node.size(); ++i)
    sum += rule.weight[i] * std::pow(rule.node[i], degree);
  return sum;
}

// The weights sum to 2, so rounding of nodes (2e-15, times the degree) and weights stays below this
TEST(GaussLegendre, IntegratesPolynomialsOfItsDegreeExactly) {
  for (int count = 1; count <= 64; ++count)
    for (int degree = 0; degree < 2 * count; ++degree) {
      const double exact = degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0;
      EXPECT_NEAR(moment(gauss_legendre(count), degree), exact, 1e-14) << count << " " << degree;
    }
}

// The next even power is missed by (2n)!-ratios: 2^(2n+1) (n!)^4 / ((2n+1) ((2n)!)^2)
TEST(GaussLegendre, MissesTheNextPowerByTheKnownError) {
  for (int count = 1; count <= 8; ++count) {
    const double factorial = std::tgamma(count + 1.0), twice = std::tgamma(2.0 * count + 1.0);
    const double error =
        std::pow(2.0, 2 * count + 1) * std::pow(factorial, 4) / ((2 * count + 1) * twice * twice);
    const double found = 2.0 / (2 * count + 1) - moment(gauss_legendre(count), 2 * count);
    EXPECT_NEAR(found, error, 1e-14) << count;
  }
}

template <unsigned kCount>
void expect_boosts_rule() {
  using Rule = boost::math::quadrature::gauss<double, kCount>;
  const QuadratureRule& rule = gauss_legendre(kCount);
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    // Boost keeps the nodes that are not negative, rising
    const std::size_t here = kCount / 2 + i;
    EXPECT_NEAR(rule.node[here], Rule::abscissa()[i], 2e-15) << kCount;
    EXPECT_NEAR(rule.weight[here], Rule::weights()[i], 2e-15) << kCount;
  }
}

TEST(GaussLegendre, EqualsBoostsRules) {
  expect_boosts_rule<7>();
  expect_boosts_rule<10>();
  expect_boosts_rule<15>();
  expect_boosts_rule<20>();
  expect_boosts_rule<30>();
}

TEST(GaussLegendre, IsSortedSymmetricAndInside) {
  for (int count = 1; count <= 64; ++count) {
    const QuadratureRule& rule = gauss_legendre(count);
    ASSERT_EQ(rule.node.size(), static_cast<std::size_t>(count));
    ASSERT_EQ(rule.weight.size(), static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      EXPECT_GT(rule.weight[i], 0.0);
      EXPECT_LT(std::abs(rule.node[i]), 1.0);
      EXPECT_NEAR(rule.node[i], -rule.node[count - 1 - i], 2e-16) << count << " " << i;
      EXPECT_NEAR(rule.weight[i], rule.weight[count - 1 - i], 4e-16) << count << " " << i;
      if (i > 0) {
        EXPECT_LT(rule.node[i - 1], rule.node[i]);
      }
    }
  }
}

TEST(GaussLegendre, RefusesCountsItDoesNotHave) {
  for (const int count : {-1, 0, 65}) EXPECT_THROW(gauss_legendre(count), InputError) << count;
}

}  // namespace
}  // namespace floe::numeric
