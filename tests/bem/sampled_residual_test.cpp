#include "expect.hpp"
#include "tiny_meshes.hpp"

#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/bem/sampled_residual.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace floe::bem {
namespace {

struct Solved {
  mesh::Q8Mesh mesh = test::rectangle_arrays(10, 4, 60.0, 20.0).build();
  ElementIntegrals integrals{mesh};
  green::GreenTable green{green::GreenFunction(0.05, 30.0), 100.0};
  MatXcd b = MatXcd::Random(mesh.node_count(), 3);
  MatXcd x = b;
  Solved() { DensePressureOperator(integrals, green).solve(x); }
};

TEST(SampledResidual, OfTheDenseSolutionIsRounding) {
  const Solved solved;
  EXPECT_LT(sampled_residual(solved.integrals, solved.green, solved.x, solved.b), 1e-13);
}

// An error e in the solution leaves the residual (I + κ𝒢)e; on all rows it is known exactly
TEST(SampledResidual, IsTheResidualOfAWrongSolution) {
  const Solved solved;
  const DensePressureOperator exact(solved.integrals, solved.green);
  MatXcd wrong = solved.x;
  wrong.col(1) += 1e-4 * MatXcd::Random(wrong.rows(), 1);
  MatXcd image(wrong.rows(), wrong.cols());
  exact.apply(wrong, image);
  const double expected = (image - solved.b).col(1).norm() / solved.b.col(1).norm();
  const Index all = wrong.rows();
  test::expect_close(sampled_residual(solved.integrals, solved.green, wrong, solved.b, all),
                     expected, 1e-9);
  // 50 random rows of 169: a mean of squares with an error of a tenth or two
  test::expect_close(sampled_residual(solved.integrals, solved.green, wrong, solved.b), expected,
                     0.5);
}

TEST(SampledResidual, SeesWhatIsNotFinite) {
  Solved solved;
  solved.x(3, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(std::isfinite(sampled_residual(solved.integrals, solved.green, solved.x, solved.b)));
}

}  // namespace
}  // namespace floe::bem
