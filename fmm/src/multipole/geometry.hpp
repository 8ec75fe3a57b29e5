#pragma once

#include "multipole/interaction_lists.hpp"

#include <algorithm>
#include <utility>

namespace floe::fmm::multipole {

/// All that a MultipolePlan holds.
struct Geometry {
  Geometry(const Points2& sources, const Points2& targets, Index leaf_size)
      : tree(tuned_quadtree(sources, targets, leaf_size)), lists(tree) {
    source_position.resize(tree.source_order.size());
    for (std::size_t i = 0; i < source_position.size(); ++i)
      source_position[tree.source_order[i]] = static_cast<Index>(i);
    target_position.resize(tree.target_order.size());
    for (std::size_t i = 0; i < target_position.size(); ++i)
      target_position[tree.target_order[i]] = static_cast<Index>(i);
    find_coincident();
    target_leaf.resize(tree.target_order.size());
    for (std::size_t b = 0; b < tree.boxes.size(); ++b)
      if (tree.boxes[b].leaf())
        std::fill(target_leaf.begin() + tree.boxes[b].target_begin,
                  target_leaf.begin() + tree.boxes[b].target_end, static_cast<std::int32_t>(b));
  }

  /// Sources of the leaves next to that of a target, in the caller's numbers, rising.
  std::vector<Index> near_sources(Index target) const;
  double memory() const;  ///< [byte]

  Quadtree tree;
  InteractionLists lists;
  std::vector<Index> source_position, target_position;  ///< in the tree's order, of the caller's
  std::vector<std::pair<Index, Index>> coincident;      ///< target, source, in the tree's order
  std::vector<std::int32_t> target_leaf;                ///< of each target in the tree's order

 private:
  void find_coincident();
};

/// Pairs of `near` that share their target: [first, last) for each target, in order.
std::vector<std::pair<Index, Index>> target_groups(const std::vector<BoxPair>& pairs);

}  // namespace floe::fmm::multipole
