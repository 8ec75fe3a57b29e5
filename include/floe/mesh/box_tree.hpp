#pragma once

#include <floe/numeric/types.hpp>

#include <algorithm>
#include <vector>

namespace floe::mesh {

/// Axis-parallel rectangle [m]; a box without area is a point.
struct Box {
  Point2 lower;
  Point2 upper;

  bool touches(const Box& other) const {
    return (lower.array() <= other.upper.array()).all() &&
           (other.lower.array() <= upper.array()).all();
  }
};

/// Box around a point, `margin` wide on every side.
inline Box box_around(const Point2& point, double margin) {
  return {point.array() - margin, point.array() + margin};
}

/// Finds the boxes that touch a box. The boxes are sorted along a Z-curve and packed eight by eight
/// into larger ones, level by level, so that strong grading and far-apart pieces cost nothing.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Calls visit(index) for every box that touches `query`; the order is fixed but not sorted.
  template <typename Visit>
  void visit(const Box& query, const Visit& visit) const {
    visit_below(query, levels_.size() - 1, 0, visit);
  }

  /// All boxes in the order of their centres along the Z-curve: neighbours stand close together.
  const std::vector<Index>& order() const { return order_; }

  /// The same indices, ascending.
  std::vector<Index> find(const Box& query) const;

 private:
  static constexpr std::size_t kChildren = 8;

  template <typename Visit>
  void visit_below(const Box& query, std::size_t level, std::size_t group,
                   const Visit& visit) const {
    const std::vector<Box>& boxes = levels_[level];
    const std::size_t end = std::min(boxes.size(), (group + 1) * kChildren);
    for (std::size_t i = group * kChildren; i < end; ++i) {
      if (!boxes[i].touches(query)) continue;
      if (level == 0)
        visit(order_[i]);
      else
        visit_below(query, level - 1, i, visit);
    }
  }

  std::vector<Index> order_;  // indices of the boxes along the Z-curve
  std::vector<std::vector<Box>>
      levels_;  // the boxes in that order, then the boxes around each eight
};

}  // namespace floe::mesh
