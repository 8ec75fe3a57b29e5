#include "multipole/geometry.hpp"

#include <algorithm>

namespace floe::fmm::multipole {

void Geometry::find_coincident() {
  for (const BoxPair& pair : lists.near) {
    const Box& target = tree.boxes[pair.target];
    const Box& source = tree.boxes[pair.source];
    for (Index i = target.target_begin; i < target.target_end; ++i)
      for (Index j = source.source_begin; j < source.source_end; ++j)
        if (tree.targets.col(i) == tree.sources.col(j)) coincident.emplace_back(i, j);
  }
}

std::vector<Index> Geometry::near_sources(Index target) const {
  const std::int32_t leaf = target_leaf[target_position[target]];
  auto pair =
      std::lower_bound(lists.near.begin(), lists.near.end(), leaf,
                       [](const BoxPair& a, std::int32_t wanted) { return a.target < wanted; });
  std::vector<Index> result;
  for (; pair != lists.near.end() && pair->target == leaf; ++pair) {
    const Box& box = tree.boxes[pair->source];
    result.insert(result.end(), tree.source_order.begin() + box.source_begin,
                  tree.source_order.begin() + box.source_end);
  }
  std::sort(result.begin(), result.end());
  return result;
}

double Geometry::memory() const {
  std::size_t bytes = sizeof(Box) * tree.boxes.size() + sizeof(coincident[0]) * coincident.size();
  bytes += 2 * sizeof(Index) * (source_position.size() + target_position.size());
  bytes += 2 * sizeof(double) * (source_position.size() + target_position.size());
  bytes += sizeof(std::int32_t) * target_leaf.size();
  bytes += sizeof(BoxPair) * (lists.near.size() + lists.wide.size() + lists.narrow.size());
  for (const LevelTranslations& level : lists.translations)
    bytes += sizeof(BoxPair) * level.pairs.size() + sizeof(Index) * level.begin.size();
  return static_cast<double>(bytes);
}

std::vector<std::pair<Index, Index>> target_groups(const std::vector<BoxPair>& pairs) {
  std::vector<std::pair<Index, Index>> groups;
  const auto count = static_cast<Index>(pairs.size());
  for (Index first = 0; first < count;) {
    Index last = first + 1;
    while (last < count && pairs[last].target == pairs[first].target) ++last;
    groups.emplace_back(first, last);
    first = last;
  }
  return groups;
}

}  // namespace floe::fmm::multipole
