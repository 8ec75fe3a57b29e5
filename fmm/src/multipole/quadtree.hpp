#pragma once

#include <floe/numeric/types.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace floe::fmm::multipole {

/// Coarsest level with expansions: above it all boxes are neighbours.
constexpr int kTopLevel = 2;

/// A square of the tree. Points of a box are consecutive in the tree's order.
struct Box {
  std::int32_t x = 0, y = 0;  ///< position in units of the level's box width
  std::int32_t level = 0;
  std::int32_t parent = -1;
  std::int32_t first_child = -1;  ///< children are consecutive; none: a leaf
  std::int32_t child_count = 0;
  Index source_begin = 0, source_end = 0;
  Index target_begin = 0, target_end = 0;

  bool leaf() const { return child_count == 0; }
  Index sources() const { return source_end - source_begin; }
  Index targets() const { return target_end - target_begin; }
};

/// Adaptive quadtree over sources and targets. Only boxes that hold points exist; they lie level
/// by level, along the Z curve within a level. All leaves are on level 2 or deeper.
struct Quadtree {
  /// Splits boxes of more than `split_above` sources or targets. `stretch` ≥ 1 enlarges the root,
  /// which is how the width of the leaves is tuned.
  Quadtree(const Points2& source_points, const Points2& target_points, Index split_above,
           double stretch);

  int levels() const { return static_cast<int>(level_begin.size()) - 1; }
  Index boxes_on(int level) const { return level_begin[level + 1] - level_begin[level]; }
  double width(int level) const { return root_width / static_cast<double>(1 << level); }
  Point2 centre(const Box& box) const;

  Point2 origin;      ///< lower left corner of the root
  double root_width;  ///< [m]
  std::vector<Box> boxes;
  std::vector<Index> level_begin;                 ///< levels + 1
  std::vector<Index> source_order, target_order;  ///< number in the caller's order of each point
  Points2 sources, targets;                       ///< in the tree's order
  bool same_points;                               ///< targets are the sources
};

/// A tree whose leaves hold between a half and twice `leaf_size` points, with the width of the
/// root that makes the sum of translations and neighbours cheapest.
Quadtree tuned_quadtree(const Points2& sources, const Points2& targets, Index leaf_size);

}  // namespace floe::fmm::multipole
