#include <floe/mesh/shape_functions.hpp>

#include <gtest/gtest.h>

namespace floe::mesh {
namespace {

// Calls test(ξ, η) on a lattice over the element
template <typename Test>
void everywhere(const Test& test) {
  for (double xi = -1.0; xi <= 1.0; xi += 0.25)
    for (double eta = -1.0; eta <= 1.0; eta += 0.25) test(xi, eta);
}

TEST(ShapeFunctions, AreOneAtTheirNodeAndZeroAtTheOthers) {
  for (int a = 0; a < 8; ++a) {
    const Eigen::Vector2d node = q8_parametric_nodes().col(a);
    EXPECT_EQ(q8_shape(node.x(), node.y()), Shape8::Unit(a)) << a;
  }
}

TEST(ShapeFunctions, NumberCornersThenMidSidesCounterClockwise) {
  const Eigen::Matrix<double, 2, 8>& nodes = q8_parametric_nodes();
  for (int side = 0; side < 4; ++side)
    EXPECT_EQ(nodes.col(4 + side), 0.5 * (nodes.col(side) + nodes.col((side + 1) % 4)));
  EXPECT_EQ(nodes.col(0), Eigen::Vector2d(-1, -1));
  EXPECT_EQ(nodes.col(1), Eigen::Vector2d(1, -1));
  EXPECT_EQ(nodes.col(2), Eigen::Vector2d(1, 1));
}

// Eight products of quarters: rounding of a few units of 2^-53
TEST(ShapeFunctions, SumToOne) {
  everywhere([](double xi, double eta) {
    EXPECT_NEAR(q8_shape(xi, eta).sum(), 1.0, 1e-15);
    EXPECT_LE(q8_shape_gradient(xi, eta).rowwise().sum().cwiseAbs().maxCoeff(), 2e-15);
  });
}

// All polynomials of the serendipity space: 1, ξ, η, ξ², ξη, η², ξ²η, ξη²
TEST(ShapeFunctions, ReproduceTheirPolynomials) {
  const auto monomials = [](double xi, double eta) {
    Shape8 values;
    values << 1.0, xi, eta, xi * xi, xi * eta, eta * eta, xi * xi * eta, xi * eta * eta;
    return values;
  };
  Eigen::Matrix<double, 8, 8> at_nodes;
  for (int a = 0; a < 8; ++a)
    at_nodes.col(a) = monomials(q8_parametric_nodes()(0, a), q8_parametric_nodes()(1, a));
  everywhere([&](double xi, double eta) {
    const Shape8 error = at_nodes * q8_shape(xi, eta) - monomials(xi, eta);
    EXPECT_LE(error.cwiseAbs().maxCoeff(), 2e-15) << xi << " " << eta;
  });
}

// Central differences of cubics: exact but for h²/6 times the third derivative (zero along an axis,
// the functions being quadratic in each variable) and rounding of 1e-16/h
TEST(ShapeFunctions, HaveTheGradientOfTheirDifferences) {
  const double h = 1.0 / 1024.0;
  everywhere([&](double xi, double eta) {
    const ShapeGradient8 gradient = q8_shape_gradient(xi, eta);
    const Shape8 along_xi = (q8_shape(xi + h, eta) - q8_shape(xi - h, eta)) / (2.0 * h);
    const Shape8 along_eta = (q8_shape(xi, eta + h) - q8_shape(xi, eta - h)) / (2.0 * h);
    EXPECT_LE((gradient.row(0).transpose() - along_xi).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LE((gradient.row(1).transpose() - along_eta).cwiseAbs().maxCoeff(), 1e-12);
  });
}

}  // namespace
}  // namespace floe::mesh
