#include "multipole/quadtree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace floe::fmm::multipole {
namespace {

constexpr int kDeepest = 24;  // levels; boxes of coincident points stop here

// Spreads the low 24 bits of x to the even positions
std::uint64_t spread_bits(std::uint64_t x) {
  x = (x | x << 16) & 0x0000ffff0000ffff;
  x = (x | x << 8) & 0x00ff00ff00ff00ff;
  x = (x | x << 4) & 0x0f0f0f0f0f0f0f0f;
  x = (x | x << 2) & 0x3333333333333333;
  return (x | x << 1) & 0x5555555555555555;
}

// Positions of points along the Z curve, sorted, with the points' numbers
struct Curve {
  std::vector<std::uint64_t> key;
  std::vector<Index> order;
};

Curve along_the_z_curve(const Points2& points, const Point2& origin, double width) {
  const double scale = std::ldexp(1.0, kDeepest) / width;
  const double last = std::ldexp(1.0, kDeepest) - 1.0;
  std::vector<std::uint64_t> key(points.cols());
  for (Index i = 0; i < points.cols(); ++i) {
    const Point2 cell = ((points.col(i) - origin) * scale).cwiseMax(0.0).cwiseMin(last);
    key[i] = spread_bits(static_cast<std::uint64_t>(cell.x())) |
             spread_bits(static_cast<std::uint64_t>(cell.y())) << 1;
  }
  Curve curve;
  curve.order.resize(points.cols());
  std::iota(curve.order.begin(), curve.order.end(), Index{0});
  std::sort(curve.order.begin(), curve.order.end(),
            [&](Index a, Index b) { return key[a] != key[b] ? key[a] < key[b] : a < b; });
  for (const Index i : curve.order) curve.key.push_back(key[i]);
  return curve;
}

// First of the sorted points of [begin, end) whose child number at `level` is at least `child`
Index split_point(const Curve& curve, Index begin, Index end, int level, unsigned child) {
  const int shift = 2 * (kDeepest - level);
  const auto found =
      std::partition_point(curve.key.begin() + begin, curve.key.begin() + end,
                           [&](std::uint64_t key) { return (key >> shift & 3) < child; });
  return found - curve.key.begin();
}

Points2 reordered(const Points2& points, const std::vector<Index>& order) {
  Points2 result(2, points.cols());
  for (Index i = 0; i < points.cols(); ++i) result.col(i) = points.col(order[i]);
  return result;
}

// The children of a box that hold points, in the order of the Z curve
std::vector<Box> children_of(const Box& box, std::int32_t number, const Curve& source,
                             const Curve& target) {
  std::vector<Box> children;
  for (unsigned c = 0; c < 4; ++c) {
    Box child;
    child.level = box.level + 1;
    child.x = 2 * box.x + static_cast<std::int32_t>(c & 1);
    child.y = 2 * box.y + static_cast<std::int32_t>(c >> 1);
    child.parent = number;
    child.source_begin = split_point(source, box.source_begin, box.source_end, child.level, c);
    child.source_end = split_point(source, box.source_begin, box.source_end, child.level, c + 1);
    child.target_begin = split_point(target, box.target_begin, box.target_end, child.level, c);
    child.target_end = split_point(target, box.target_begin, box.target_end, child.level, c + 1);
    if (child.sources() + child.targets() > 0) children.push_back(child);
  }
  return children;
}

}  // namespace

Quadtree::Quadtree(const Points2& source_points, const Points2& target_points, Index split_above,
                   double stretch)
    : same_points(source_points.cols() == target_points.cols() && source_points == target_points) {
  // Enclose all points in a square
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Point2 low(kInfinity, kInfinity), high(-kInfinity, -kInfinity);
  for (const Points2* points : {&source_points, &target_points})
    if (points->cols() > 0) {
      low = low.cwiseMin(points->rowwise().minCoeff());
      high = high.cwiseMax(points->rowwise().maxCoeff());
    }
  if (!(low.x() <= high.x())) low = high = Point2::Zero();
  const double extent = (high - low).maxCoeff();
  root_width = extent > 0.0 ? extent * stretch * (1.0 + 1e-9) : 1.0;
  origin = low;

  // Sort the points along the Z curve
  Curve source = along_the_z_curve(source_points, origin, root_width);
  Curve target = same_points ? source : along_the_z_curve(target_points, origin, root_width);

  // Split boxes level by level
  Box root;
  root.source_end = source_points.cols();
  root.target_end = target_points.cols();
  boxes.push_back(root);
  level_begin = {0, 1};
  for (int level = 0; level < kDeepest; ++level) {
    for (Index b = level_begin[level]; b < level_begin[level + 1]; ++b) {
      if (level >= kTopLevel && std::max(boxes[b].sources(), boxes[b].targets()) <= split_above)
        continue;
      const std::vector<Box> children =
          children_of(boxes[b], static_cast<std::int32_t>(b), source, target);
      boxes[b].first_child = static_cast<std::int32_t>(boxes.size());
      boxes[b].child_count = static_cast<std::int32_t>(children.size());
      boxes.insert(boxes.end(), children.begin(), children.end());
    }
    if (static_cast<Index>(boxes.size()) == level_begin.back()) break;
    level_begin.push_back(static_cast<Index>(boxes.size()));
  }
  sources = reordered(source_points, source.order);
  targets = reordered(target_points, target.order);
  source_order = std::move(source.order);
  target_order = std::move(target.order);
}

Point2 Quadtree::centre(const Box& box) const {
  return origin + width(box.level) * Point2(box.x + 0.5, box.y + 0.5);
}

Quadtree tuned_quadtree(const Points2& sources, const Points2& targets, Index leaf_size) {
  // Neighbours cost their pairs; the translations to a box as much as those of an ideal leaf
  const auto cost = [&](const Quadtree& tree) {
    double sum = 0.0;
    const double ideal = static_cast<double>(leaf_size) * static_cast<double>(leaf_size);
    for (const Box& box : tree.boxes)
      sum += ideal + (box.leaf() ? static_cast<double>(box.sources() * box.targets()) : 0.0);
    return sum;
  };
  double stretch = 1.0;
  double least = std::numeric_limits<double>::infinity();
  for (const double candidate : {1.0, 1.19, 1.41, 1.68}) {
    const double here = cost(Quadtree(sources, targets, 2 * leaf_size, candidate));
    if (here < least) {
      least = here;
      stretch = candidate;
    }
  }
  return Quadtree(sources, targets, 2 * leaf_size, stretch);
}

}  // namespace floe::fmm::multipole
