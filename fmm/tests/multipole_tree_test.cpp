#include "multipole/geometry.hpp"
#include "multipole_points.hpp"

#include <gtest/gtest.h>

namespace floe::fmm::multipole {
namespace {

using test::clustered_points;
using test::far_groups;
using test::uniform_points;

void mark(const Quadtree& tree, const std::vector<BoxPair>& pairs, Eigen::MatrixXi& covered) {
  for (const BoxPair& pair : pairs) {
    const Box& t = tree.boxes[pair.target];
    const Box& s = tree.boxes[pair.source];
    covered.block(t.target_begin, s.source_begin, t.targets(), s.sources()).array() += 1;
  }
}

void expect_every_pair_once(const Points2& sources, const Points2& targets) {
  const Geometry geometry(sources, targets, 6);
  Eigen::MatrixXi covered = Eigen::MatrixXi::Zero(targets.cols(), sources.cols());
  for (const LevelTranslations& level : geometry.lists.translations)
    mark(geometry.tree, level.pairs, covered);
  mark(geometry.tree, geometry.lists.near, covered);
  mark(geometry.tree, geometry.lists.wide, covered);
  mark(geometry.tree, geometry.lists.narrow, covered);
  EXPECT_EQ(covered.minCoeff(), 1);
  EXPECT_EQ(covered.maxCoeff(), 1);
}

TEST(InteractionLists, CoverEveryPairOfPointsExactlyOnce) {
  expect_every_pair_once(uniform_points(900, 1), uniform_points(900, 1));
  expect_every_pair_once(uniform_points(900, 1), uniform_points(500, 2));
  expect_every_pair_once(clustered_points(900, 3), clustered_points(900, 3));
  expect_every_pair_once(clustered_points(900, 3), uniform_points(700, 4));
  expect_every_pair_once(uniform_points(700, 4), clustered_points(900, 3));
  expect_every_pair_once(far_groups(900, 5), far_groups(900, 5));
  expect_every_pair_once(far_groups(900, 5), clustered_points(400, 6));
}

// Between boxes of one width at least one box, between boxes of two the narrower one
TEST(InteractionLists, KeepFarBoxesAWidthOfTheNarrowerOneApart) {
  const Points2 points = clustered_points(3000, 8);
  const Geometry geometry(points, uniform_points(1000, 9), 6);
  const Quadtree& tree = geometry.tree;
  const auto gap = [&](const BoxPair& pair) {
    const Box& a = tree.boxes[pair.target];
    const Box& b = tree.boxes[pair.source];
    const double apart = (tree.centre(a) - tree.centre(b)).cwiseAbs().maxCoeff();
    const double wa = tree.width(a.level), wb = tree.width(b.level);
    return (apart - 0.5 * (wa + wb)) / std::min(wa, wb);
  };
  for (const LevelTranslations& level : geometry.lists.translations)
    for (const BoxPair& pair : level.pairs) EXPECT_GE(gap(pair), 1.0 - 1e-6);
  for (const BoxPair& pair : geometry.lists.wide) EXPECT_GE(gap(pair), 1.0 - 1e-6);
  for (const BoxPair& pair : geometry.lists.narrow) EXPECT_GE(gap(pair), 1.0 - 1e-6);
}

TEST(InteractionLists, GrowInProportionToClusteredPoints) {
  const auto work = [](Index count) {
    const Points2 points = clustered_points(count, 10);
    const Geometry geometry(points, points, 20);
    double pairs = 0.0;
    for (const BoxPair& pair : geometry.lists.near)
      pairs += static_cast<double>(geometry.tree.boxes[pair.target].targets() *
                                   geometry.tree.boxes[pair.source].sources());
    for (const LevelTranslations& level : geometry.lists.translations)
      pairs += 200.0 * static_cast<double>(level.pairs.size());
    return pairs / static_cast<double>(count);
  };
  EXPECT_LE(work(40000), 1.5 * work(5000));
}

TEST(Quadtree, HoldsEachPointInOneLeafThatEnclosesIt) {
  const Points2 points = clustered_points(2000, 11);
  const Quadtree tree(points, points, 12, 1.3);
  std::vector<int> found(points.cols());
  for (const Box& box : tree.boxes) {
    if (!box.leaf()) continue;
    EXPECT_LE(box.sources(), 12);
    EXPECT_GE(box.level, kTopLevel);
    for (Index i = box.source_begin; i < box.source_end; ++i) {
      ++found[tree.source_order[i]];
      EXPECT_LE((tree.sources.col(i) - tree.centre(box)).cwiseAbs().maxCoeff(),
                0.5 * tree.width(box.level) * (1.0 + 1e-6));
    }
  }
  EXPECT_EQ(found, std::vector<int>(points.cols(), 1));
}

TEST(Quadtree, EndsAtCoincidentPoints) {
  const Points2 points = Points2::Constant(2, 500, 0.25);
  const Geometry geometry(points, points, 4);
  EXPECT_EQ(geometry.coincident.size(), 250000u);
}

}  // namespace
}  // namespace floe::fmm::multipole
