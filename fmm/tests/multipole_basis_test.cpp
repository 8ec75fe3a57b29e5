#include "multipole/interpolative.hpp"
#include "multipole/translations.hpp"
#include "multipole_points.hpp"

#include <gtest/gtest.h>

namespace floe::fmm::multipole {
namespace {

using test::uniform_points;
using test::WaterLikeKernel;

constexpr double kTolerance = 1e-5;
constexpr double kWidth = 0.25;

Points2 in_box(Index count, double width, unsigned seed) {
  return (uniform_points(count, seed).array() - 0.5).matrix() * width;
}

MatXd moments(const Bases& bases, std::size_t level, const Points2& points) {
  return bases[level].restrict * skeleton_weights(bases, level, points);
}

// A basis loses kTolerance in the mean over charges and rings; three times of it is allowed where
// two losses meet or the points are not those of the mean
constexpr double kAllowed = 3.0 * kTolerance;

class Basis : public testing::TestWithParam<double> {
 protected:
  WaterLikeKernel kernel{GetParam()};
  Bases bases = make_bases(kernel, kWidth, 3, 1.0, kTolerance);
};

TEST_P(Basis, CarriesTheFieldOutsideTheNeighbours) {
  for (std::size_t level = 0; level < 3; ++level) {
    const LevelBasis& basis = bases[level];
    const Points2 points = in_box(60, basis.width, 1);
    const Points2 far = in_box(80, basis.width, 2).colwise() + Point2(2.0, -1.0) * basis.width;
    const MatXcd exact = kernel_matrix(kernel, far, points);
    const MatXcd carried = kernel_matrix(kernel, far, basis.skeleton) *
                           (basis.expand * moments(bases, level, points)).cast<Complex>();
    EXPECT_LE((carried - exact).norm(), kAllowed * exact.norm()) << "level " << level;
  }
}

TEST_P(Basis, TranslatesBetweenBoxes) {
  for (std::size_t level = 0; level < 3; ++level) {
    const LevelBasis& basis = bases[level];
    const Points2 sources = in_box(60, basis.width, 3), targets = in_box(60, basis.width, 4);
    const Point2 offset = Point2(-3.0, 1.0) * basis.width;
    const MatXcd exact = kernel_matrix(kernel, targets, sources.colwise() + offset);
    const MatXd real = moments(bases, level, targets).transpose() *
                       box_to_box_real(kernel, basis, offset) * moments(bases, level, sources);
    EXPECT_LE((real - exact.real()).norm(), kAllowed * exact.norm()) << "level " << level;
  }
}

// Im G has no near field: it is carried to the box itself and to its neighbours
TEST_P(Basis, CouplesTheSmoothPartAtAnyDistance) {
  const LevelBasis& basis = bases[0];
  const Points2 sources = in_box(60, basis.width, 5), targets = in_box(60, basis.width, 6);
  for (const Point2& cells : {Point2(0.0, 0.0), Point2(1.0, 0.0), Point2(2.0, 3.0)}) {
    const Point2 offset = cells * basis.width;
    const MatXcd exact = kernel_matrix(kernel, targets, sources.colwise() + offset);
    const MatXd imag = moments(bases, 0, targets).transpose() *
                       box_to_box_imag(kernel, basis, offset) * moments(bases, 0, sources);
    EXPECT_LE((imag - exact.imag()).norm(), kAllowed * exact.norm());
  }
}

TEST_P(Basis, ShiftsMomentsToTheParent) {
  for (std::size_t level = 0; level < 2; ++level)
    for (int child = 0; child < 4; ++child) {
      const LevelBasis& parent = bases[level];
      const Points2 points = in_box(60, bases[level + 1].width, 7);
      const Points2 there = points.colwise() + child_centre(child, parent.width);
      const Points2 far = in_box(80, parent.width, 8).colwise() + Point2(2.0, 0.0) * parent.width;
      const MatXcd exact = kernel_matrix(kernel, far, there);
      const MatXd shifted =
          child_to_parent(bases, level, child) * moments(bases, level + 1, points);
      const MatXcd carried =
          kernel_matrix(kernel, far, parent.skeleton) * (parent.expand * shifted).cast<Complex>();
      EXPECT_LE((carried - exact).norm(), kAllowed * exact.norm());
    }
}

// Boxes of no, one and twelve waves; the last ones are built from their children
INSTANTIATE_TEST_SUITE_P(Waves, Basis, testing::Values(0.1, 25.0, 300.0));

TEST(InterpolativeDecomposition, ReproducesAllColumnsFromAFew) {
  const WaterLikeKernel kernel(3.0);
  const Points2 far = uniform_points(70, 9).colwise() + Point2(2.0, 1.0);
  const MatXd fields = kernel_matrix(kernel, far, uniform_points(50, 10)).real();
  const Interpolative found = interpolative_decomposition(fields, 1e-7);
  MatXd chosen(fields.rows(), found.columns.size());
  for (std::size_t j = 0; j < found.columns.size(); ++j)
    chosen.col(j) = fields.col(found.columns[j]);
  EXPECT_LT(found.columns.size(), 30u);
  // No column is left with more than the tolerance of the largest one
  EXPECT_LE((chosen * found.interpolation - fields).colwise().norm().maxCoeff(),
            1.001e-7 * fields.colwise().norm().maxCoeff());
}

}  // namespace
}  // namespace floe::fmm::multipole
