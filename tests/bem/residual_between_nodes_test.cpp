#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/bem/residual_between_nodes.hpp>
#include <floe/mesh/rectangle.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace floe::bem {
namespace {

// A heaving plate, 40 × 20 m, in waves of 40 m
double residual_of_heave(int nx, double scale = 1.0) {
  const mesh::Q8Mesh mesh =
      mesh::make_rectangle({.length = 40.0, .width = 20.0, .nx = nx, .ny = nx / 2});
  const ElementIntegrals integrals(mesh);
  const green::GreenTable green(green::GreenFunction(0.157, 20.0), 50.0);
  const MatXcd b = MatXcd::Ones(mesh.node_count(), 1);
  MatXcd x = b;
  DensePressureOperator(integrals, green).solve(x);
  return residual_between_nodes(integrals, green, scale * x, b);
}

TEST(ResidualBetweenNodes, FallsAsElementsShrink) {
  const double coarse = residual_of_heave(8), fine = residual_of_heave(16);
  EXPECT_GT(coarse, 1e-6);
  EXPECT_LT(fine, 0.6 * coarse);
}

// b - (I + κ𝒢)sx = (1 - s)b where x solves the equation, whatever 𝒢 is
TEST(ResidualBetweenNodes, SeesASolutionThatIsTooSmall) {
  EXPECT_NEAR(residual_of_heave(16, 0.5), 0.5, residual_of_heave(16));
}

}  // namespace
}  // namespace floe::bem
