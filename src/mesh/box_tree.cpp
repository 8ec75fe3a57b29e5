#include <floe/mesh/box_tree.hpp>

#include <cstdint>
#include <utility>

namespace floe::mesh {
namespace {

// Puts a zero between any two of the lower 32 bits
std::uint64_t spread_bits(std::uint64_t bits) {
  bits = (bits | (bits << 16)) & 0x0000ffff0000ffffULL;
  bits = (bits | (bits << 8)) & 0x00ff00ff00ff00ffULL;
  bits = (bits | (bits << 4)) & 0x0f0f0f0f0f0f0f0fULL;
  bits = (bits | (bits << 2)) & 0x3333333333333333ULL;
  return (bits | (bits << 1)) & 0x5555555555555555ULL;
}

Box merge(const Box& a, const Box& b) {
  return {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)};
}

// Indices of the boxes in the order of their centres along a Z-curve
std::vector<Index> z_order(const std::vector<Box>& boxes) {
  Box around = boxes.front();
  for (const Box& box : boxes) around = merge(around, box);
  const double extent = std::max((around.upper - around.lower).maxCoeff(), 1e-300);
  std::vector<std::pair<std::uint64_t, Index>> keys(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Point2 centre = 0.5 * (boxes[i].lower + boxes[i].upper);
    const Point2 scaled = (centre - around.lower) / extent * 2147483647.0;
    keys[i] = {spread_bits(static_cast<std::uint64_t>(scaled.x())) |
                   spread_bits(static_cast<std::uint64_t>(scaled.y())) << 1,
               static_cast<Index>(i)};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Index> order(boxes.size());
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](const auto& key) { return key.second; });
  return order;
}

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes) : levels_(1) {
  if (boxes.empty()) return;
  order_ = z_order(boxes);
  for (const Index i : order_) levels_[0].push_back(boxes[i]);
  while (levels_.back().size() > kChildren) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> above;
    for (std::size_t i = 0; i < below.size(); ++i) {
      if (i % kChildren == 0)
        above.push_back(below[i]);
      else
        above.back() = merge(above.back(), below[i]);
    }
    levels_.push_back(std::move(above));
  }
}

std::vector<Index> BoxTree::find(const Box& query) const {
  std::vector<Index> found;
  visit(query, [&](Index i) { found.push_back(i); });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace floe::mesh
