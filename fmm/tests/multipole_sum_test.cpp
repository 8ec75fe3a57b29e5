#include "multipole_points.hpp"

#include <floe/fmm/direct_sum.hpp>
#include <floe/fmm/multipole_sum.hpp>
#include <floe/fmm/sampled_error.hpp>
#include <floe/numeric/error.hpp>

#include <gtest/gtest.h>
#include <omp.h>

#include <limits>

namespace floe::fmm {
namespace {

using test::clustered_points;
using test::far_groups;
using test::random_charges;
using test::uniform_points;
using test::WaterLikeKernel;

std::shared_ptr<const MultipolePlan> make_plan(const Points2& sources, const Points2& targets) {
  return std::make_shared<const MultipolePlan>(sources, targets, MultipoleOptions{.leaf_size = 8});
}

MatXcd applied(const KernelSum& sum, const MatXcd& charges) {
  MatXcd potentials(sum.target_count(), charges.cols());
  sum.apply(charges, potentials);
  return potentials;
}

TEST(MultipoleSum, MeetsItsToleranceOnAnyTargets) {
  const WaterLikeKernel kernel(12.0);
  const Points2 sources = clustered_points(1500, 1);
  for (const Points2& targets : {uniform_points(700, 2), sources, far_groups(900, 3)}) {
    const std::shared_ptr<const MultipolePlan> plan = make_plan(sources, targets);
    const DirectSum truth(sources, targets, kernel);
    const MatXcd charges = random_charges(1500, 1, 4);
    for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
      const MultipoleSum sum(plan, kernel, tolerance);
      EXPECT_LE(sampled_error(truth, charges, applied(sum, charges)), tolerance);
    }
  }
}

// (F.2): the far part plus, for near pairs, the kernel minus what the far part holds already
TEST(MultipoleSum, IsItsFarPartPlusTheRestOfNearPairs) {
  const WaterLikeKernel kernel(4.0);
  const Points2 sources = clustered_points(800, 5);
  Points2 targets = uniform_points(300, 6);
  targets.leftCols(40) = sources.leftCols(40);  // some coincide
  const MultipoleSum sum(make_plan(sources, targets), kernel, 1e-9);
  const MatXcd charges = random_charges(800, 2, 7);
  MatXcd potentials(300, 2);
  sum.far_apply(charges, potentials);
  for (Index i = 0; i < 300; ++i) {
    const std::vector<Index> near = sum.near_sources(i);
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
    std::vector<Complex> held(near.size());
    sum.far_values(i, near, held);
    for (std::size_t k = 0; k < near.size(); ++k) {
      const double distance = (sources.col(near[k]) - targets.col(i)).norm();
      Complex value = 0.0;
      if (distance > 0.0) kernel.evaluate({&distance, 1}, {&value, 1});
      potentials.row(i) += (value - held[k]) * charges.row(near[k]);
    }
  }
  const DirectSum truth(sources, targets, kernel);
  EXPECT_LE(sampled_error(truth, charges, potentials), 1e-9);
}

TEST(MultipoleSum, GivesTheSameBitsForAnyThreads) {
  const WaterLikeKernel kernel(10.0);
  const Points2 sources = clustered_points(1500, 8), targets = uniform_points(1200, 9);
  const MatXcd charges = random_charges(1500, 3, 10);
  const int before = omp_get_max_threads();
  for (const double tolerance : {1e-4, 1e-7}) {
    MatXcd first;
    for (const int threads : {1, 2, 3, 7}) {
      omp_set_num_threads(threads);
      const MultipoleSum sum(make_plan(sources, targets), kernel, tolerance);
      const MatXcd potentials = applied(sum, charges);
      if (threads == 1) first = potentials;
      EXPECT_EQ(potentials, first) << threads << " threads";
    }
  }
  omp_set_num_threads(before);
}

TEST(MultipoleSum, GivesTheSameBitsForAColumnAloneOrInABlock) {
  const WaterLikeKernel kernel(10.0);
  const Points2 points = clustered_points(1500, 11);
  const MatXcd charges = random_charges(1500, 5, 12);
  for (const double tolerance : {1e-4, 1e-7}) {
    const MultipoleSum sum(make_plan(points, points), kernel, tolerance);
    const MatXcd block = applied(sum, charges);
    for (Index column = 0; column < 5; ++column)
      EXPECT_EQ(applied(sum, charges.col(column)), block.col(column));
  }
}

TEST(MultipoleSum, StoresNeighboursWithoutChangingABit) {
  const WaterLikeKernel kernel(10.0);
  const Points2 points = uniform_points(900, 13);
  const MatXcd charges = random_charges(900, 2, 14);
  const std::shared_ptr<const MultipolePlan> plan = make_plan(points, points);
  EXPECT_EQ(applied(MultipoleSum(plan, kernel, 1e-5, NearSums::kStored), charges),
            applied(MultipoleSum(plan, kernel, 1e-5, NearSums::kEvaluated), charges));
}

// Single precision inside has room for 1e±38 only
TEST(MultipoleSum, ScalesWithTheCharges) {
  const WaterLikeKernel kernel(10.0);
  const Points2 points = uniform_points(500, 15);
  const MatXcd charges = random_charges(500, 1, 16);
  const MultipoleSum sum(make_plan(points, points), kernel, 1e-3);
  const MatXcd once = applied(sum, charges);
  for (const int exponent : {-600, 600}) {
    const double scale = std::ldexp(1.0, exponent);
    EXPECT_EQ(applied(sum, scale * charges), scale * once);
  }
}

TEST(MultipoleSum, LeavesOutCoincidentPoints) {
  const WaterLikeKernel kernel(2.0);
  Points2 points(2, 40);
  points << Points2::Constant(2, 20, 0.5), uniform_points(20, 17);
  const MultipoleSum sum(make_plan(points, points), kernel, 1e-6);
  const MatXcd charges = random_charges(40, 1, 18);
  EXPECT_LE(sampled_error(DirectSum(points, points, kernel), charges, applied(sum, charges)), 1e-6);
}

TEST(MultipoleSum, IsZeroWhereThereIsNothingToSum) {
  const WaterLikeKernel kernel(2.0);
  const Points2 none(2, 0), one = Points2::Constant(2, 1, 3.0);
  EXPECT_EQ(applied(MultipoleSum(make_plan(none, one), kernel, 1e-4), MatXcd(0, 2)),
            MatXcd::Zero(1, 2));
  EXPECT_EQ(applied(MultipoleSum(make_plan(one, none), kernel, 1e-4), MatXcd::Ones(1, 2)).size(),
            0);
  // Alone with itself: nothing but what rounding leaves of c - c
  const double c = std::abs(kernel.wave().coefficient);
  EXPECT_LE(applied(MultipoleSum(make_plan(one, one), kernel, 1e-8), MatXcd::Ones(1, 1)).norm(),
            1e-8 * c);
}

TEST(MultipoleSum, RejectsWhatItCannotSum) {
  const WaterLikeKernel kernel(2.0);
  Points2 points = uniform_points(10, 19);
  const std::shared_ptr<const MultipolePlan> plan = make_plan(points, points);
  EXPECT_THROW(MultipoleSum(plan, kernel, 0.0), InputError);
  EXPECT_THROW(MultipoleSum(plan, kernel, 1.0), InputError);
  EXPECT_THROW(MultipolePlan(points, points, {.leaf_size = 0}), InputError);
  points(1, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(MultipolePlan(points, points), InputError);
}

}  // namespace
}  // namespace floe::fmm
