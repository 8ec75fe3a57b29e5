#include <floe/mesh/box_tree.hpp>

#include <gtest/gtest.h>

#include <random>

namespace floe::mesh {
namespace {

std::vector<Index> slow_find(const std::vector<Box>& boxes, const Box& query) {
  std::vector<Index> found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (boxes[i].touches(query)) found.push_back(static_cast<Index>(i));
  return found;
}

TEST(twin_BoxTree, FindsWhatASearchOfAllBoxesFinds) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const std::size_t count : {0, 1, 7, 8, 9, 64, 65, 1000}) {
    std::vector<Box> boxes(count);
    for (Box& box : boxes) {
      // Sizes over four decades, some boxes far away
      const double far = unit(random) < 0.1 ? 1e6 : 1.0;
      box.lower = far * Point2(unit(random), unit(random));
      box.upper = box.lower + std::pow(10.0, -4.0 * unit(random)) * Point2(unit(random), 1.0);
    }
    const BoxTree tree(boxes);
    for (int i = 0; i < 200; ++i) {
      const Box query = box_around({unit(random), unit(random)}, 0.1 * unit(random));
      EXPECT_EQ(tree.find(query), slow_find(boxes, query)) << count;
    }
  }
}

TEST(BoxTree, CountsTouchingBoxes) {
  const BoxTree tree({{{0, 0}, {1, 1}}, {{1, 1}, {2, 2}}});
  EXPECT_EQ(tree.find({{1, 1}, {1, 1}}), (std::vector<Index>{0, 1}));
  EXPECT_EQ(tree.find({{2, 2}, {3, 3}}), (std::vector<Index>{1}));
  EXPECT_TRUE(tree.find({{2.1, 0}, {3, 3}}).empty());
}

}  // namespace
}  // namespace floe::mesh
