#include <floe/fmm/direct_sum.hpp>
#include <floe/fmm/pfft_sum.hpp>
#include <floe/fmm/sampled_error.hpp>
#include <floe/numeric/error.hpp>

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace floe::fmm {
namespace {

// 2 e^{ikR}/R: singular like the Green function, and travels
class WaveKernel final : public RadialKernel {
 public:
  explicit WaveKernel(double wavenumber) : wavenumber_(wavenumber) {}
  void evaluate(std::span<const double> distance, std::span<Complex> value) const override {
    for (std::size_t i = 0; i < distance.size(); ++i)
      value[i] = std::polar(2.0 / distance[i], wavenumber_ * distance[i]);
  }
  WaveTerm wave() const override { return {wavenumber_, Complex(0.0, 1.0)}; }

 private:
  double wavenumber_;
};

Points2 random_points(Index count, double length, double width, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Points2 points(2, count);
  for (Index i = 0; i < count; ++i)
    points.col(i) << length * uniform(engine), width * uniform(engine);
  return points;
}

MatXcd random_charges(Index count, Index columns) {
  std::mt19937 engine(7);
  std::normal_distribution<double> normal;
  MatXcd charges(count, columns);
  for (Index c = 0; c < columns; ++c)
    for (Index i = 0; i < count; ++i) charges(i, c) = {normal(engine), normal(engine)};
  return charges;
}

std::shared_ptr<const PfftPlan> make_plan(const Points2& sources, const Points2& targets,
                                          double tolerance, double wavenumber) {
  return std::make_shared<const PfftPlan>(
      sources, targets, PfftOptions{.tolerance = tolerance, .max_wavenumber = wavenumber});
}

TEST(PfftSum, KeepsEveryToleranceThatIsAsked) {
  const Points2 sources = random_points(3000, 2.0, 1.0, 1),
                targets = random_points(800, 1.0, 2.0, 2);
  const MatXcd charges = random_charges(3000, 2);
  for (const double wavenumber : {0.0, 30.0})
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
      const WaveKernel kernel(wavenumber);
      const PfftSum sum(make_plan(sources, targets, tolerance, wavenumber), kernel);
      MatXcd potentials(800, 2);
      sum.apply(charges, potentials);
      const double error =
          sampled_error(DirectSum(sources, targets, kernel), charges, potentials, 800);
      EXPECT_LE(error, tolerance) << "k = " << wavenumber;
      EXPECT_GE(error, 0.01 * tolerance) << "k = " << wavenumber;
    }
}

TEST(PfftSum, KeepsItsToleranceForGradedAndClusteredPoints) {
  const Index count = 3000;
  Points2 graded = random_points(count, 2.0, 1.0, 11), clustered = graded;
  graded.row(0) = graded.row(0).array().square();
  std::mt19937 engine(12);
  std::normal_distribution<double> normal(0.0, 0.02);
  for (Index i = 0; i < count; ++i)
    clustered.col(i) = clustered.col(i % 30) + Point2(normal(engine), normal(engine));
  const MatXcd charges = random_charges(count, 1);
  for (const Points2& points : {graded, clustered})
    for (const double wavenumber : {0.0, 30.0})
      for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-7}) {
        const WaveKernel kernel(wavenumber);
        const PfftSum sum(make_plan(points, points, tolerance, wavenumber), kernel);
        MatXcd potentials(count, 1);
        sum.apply(charges, potentials);
        EXPECT_LE(sampled_error(DirectSum(points, points, kernel), charges, potentials), tolerance)
            << "k = " << wavenumber;
      }
}

TEST(PfftSum, AgreesWhereItsPointsFormTwoGroupsFarApart) {
  Points2 points = random_points(1500, 1.0, 1.0, 3);
  points.rightCols(750).colwise() += Point2(1.0, 9.0);
  const MatXcd charges = random_charges(1500, 1);
  const WaveKernel kernel(5.0);
  for (const double tolerance : {1e-3, 1e-5}) {
    const PfftSum sum(make_plan(points, points, tolerance, 5.0), kernel);
    MatXcd potentials(1500, 1);
    sum.apply(charges, potentials);
    EXPECT_LE(sampled_error(DirectSum(points, points, kernel), charges, potentials, 1500),
              tolerance);
  }
}

TEST(PfftSum, SplitsIntoItsFarPartAndNearPairs) {
  // (F.2), pair by pair with unit charges in effect: far + Σ near (G - far value) = apply, to the
  // rounding of single precision. Not with waves: `apply` leaves the smooth Im G of near pairs to
  // the grid, which has it to the tolerance only.
  const Points2 points = random_points(300, 3.0, 1.0, 4);
  const WaveKernel kernel(0.0);
  const PfftSum sum(make_plan(points, points, 1e-4, 0.0), kernel);
  const MatXcd charges = random_charges(300, 1);
  MatXcd potentials(300, 1), whole(300, 1);
  sum.far_apply(charges, potentials);
  sum.apply(charges, whole);
  for (Index target = 0; target < 300; ++target) {
    const std::vector<Index> sources = sum.near_sources(target);
    EXPECT_TRUE(std::is_sorted(sources.begin(), sources.end()));
    EXPECT_EQ(std::adjacent_find(sources.begin(), sources.end()), sources.end());
    EXPECT_TRUE(std::binary_search(sources.begin(), sources.end(), target));
    std::vector<Complex> values(sources.size());
    sum.far_values(target, sources, values);
    for (std::size_t k = 0; k < sources.size(); ++k) {
      const double distance = (points.col(sources[k]) - points.col(target)).norm();
      Complex exact = 0.0;
      if (distance > 0.0) kernel.evaluate({&distance, 1}, {&exact, 1});
      potentials(target, 0) += (exact - values[k]) * charges(sources[k], 0);
    }
  }
  EXPECT_LE((potentials - whole).norm(), 1e-6 * whole.norm());
}

TEST(PfftSum, TellsWhatItsFarPartContains) {
  // A unit charge shows the grid's value of every near pair, to rounding
  const Points2 points = random_points(120, 2.0, 1.0, 5);
  for (const double tolerance : {1e-4, 1e-7}) {
    const PfftSum sum(make_plan(points, points, tolerance, 1.0), WaveKernel(1.0),
                      PfftSum::Parts::far_only);
    const double rounding = tolerance < 1e-6 ? 1e-11 : 1e-6;
    for (const Index source : {0, 57, 119}) {
      MatXcd unit = MatXcd::Zero(120, 1), far(120, 1);
      unit(source, 0) = 1.0;
      sum.far_apply(unit, far);
      for (Index target = 0; target < 120; ++target) {
        const std::vector<Index> near = sum.near_sources(target);
        if (!std::binary_search(near.begin(), near.end(), source)) continue;
        Complex value;
        sum.far_values(target, {&source, 1}, {&value, 1});
        EXPECT_LE(std::abs(value - far(target, 0)), rounding * far.cwiseAbs().maxCoeff());
      }
    }
    MatXcd potentials(120, 1);
    EXPECT_THROW(sum.apply(MatXcd::Zero(120, 1), potentials), InputError);
  }
}

TEST(PfftSum, IsSymmetricWhereTargetsAreSources) {
  const Points2 points = random_points(500, 2.0, 1.0, 6);
  const PfftSum sum(make_plan(points, points, 1e-7, 3.0), WaveKernel(3.0));
  const MatXcd x = random_charges(500, 2);
  MatXcd y(500, 2);
  sum.apply(x, y);
  const Complex left = (x.col(0).transpose() * y.col(1))(0),
                right = (x.col(1).transpose() * y.col(0))(0);
  EXPECT_LE(std::abs(left - right), 1e-12 * x.norm() * y.norm());
}

TEST(PfftSum, GivesTheSameBitsForAnyThreadsAndForAColumnAlone) {
  const Points2 points = random_points(2000, 1.0, 3.0, 8);
  const MatXcd charges = random_charges(2000, 6);
  const WaveKernel kernel(4.0);
  const int before = omp_get_max_threads();
  MatXcd first;
  for (const int threads : {1, 2, 3, 7}) {
    omp_set_num_threads(threads);
    const PfftSum sum(make_plan(points, points, 1e-4, 4.0), kernel);
    MatXcd block(2000, 6), alone(2000, 1);
    sum.apply(charges, block);
    sum.apply(charges.col(1), alone);
    if (first.size() == 0) first = block;
    EXPECT_TRUE(block == first) << threads << " threads";
    EXPECT_TRUE(alone.col(0) == first.col(1)) << threads << " threads";
  }
  omp_set_num_threads(before);
}

TEST(PfftPlan, RefusesClusteredPoints) {
  // Ten clusters, each a millionth of the whole: a grid that resolves them or near lists of all
  // pairs inside, neither fits
  Points2 points = random_points(20000, 1e-6, 1e-6, 9);
  for (Index i = 0; i < points.cols(); ++i)
    points.col(i) += Point2(std::floor(i / 2000.0), static_cast<double>(i % 2));
  EXPECT_THROW(PfftPlan(points, points, {.memory_budget = 4e7}), BudgetError);
}

TEST(PfftPlan, RejectsInvalidArguments) {
  const Points2 points = random_points(10, 1.0, 1.0, 10);
  Points2 broken = points;
  broken(0, 3) = std::nan("");
  EXPECT_THROW(PfftPlan(broken, points), InputError);
  EXPECT_THROW(PfftPlan(Points2(2, 0), points), InputError);
  EXPECT_THROW(PfftPlan(points, points, {.tolerance = 1e-9}), InputError);
  EXPECT_THROW(PfftSum(make_plan(points, points, 1e-3, 1.0), WaveKernel(2.0)), InputError);
}

}  // namespace
}  // namespace floe::fmm
