#pragma once

#include "multipole/quadtree.hpp"

namespace floe::fmm::multipole {

/// Two boxes, by number in the tree.
struct BoxPair {
  std::int32_t target, source;
};

/// Offsets source - target of boxes of one level lie in [-3, 3]²; they are numbered row by row.
constexpr int kOffsets = 49;
constexpr int offset_number(int dx, int dy) { return 7 * (dy + 3) + dx + 3; }

/// Translations of one level: consecutive target boxes form a chunk, the unit of work of a thread;
/// within a chunk the pairs are sorted by offset.
struct LevelTranslations {
  Index chunks() const { return static_cast<Index>(begin.size()) / kOffsets; }
  std::vector<BoxPair> pairs;
  std::vector<Index> begin;  ///< chunks × offsets, and the end
};

/// Who acts on whom. Every pair (target, source) of points is covered exactly once: by a near
/// pair of leaves, or by a translation, a wide or a narrow pair of their ancestors.
struct InteractionLists {
  explicit InteractionLists(const Quadtree& tree);

  std::vector<LevelTranslations>
      translations;             ///< a level each: the boxes do not touch, their parents do
  std::vector<BoxPair> near;    ///< adjacent leaves, sorted by target
  std::vector<BoxPair> wide;    ///< target a leaf, wider than the source, which it does not touch
  std::vector<BoxPair> narrow;  ///< the other way round: source a leaf, wider than the target
};

}  // namespace floe::fmm::multipole
