#include "multipole/interaction_lists.hpp"

#include <algorithm>
#include <cstdlib>

namespace floe::fmm::multipole {
namespace {

constexpr Index kChunk = 64;      // target boxes
constexpr Index kFewPoints = 16;  // leaves of fewer points act directly on a wider one

bool touch(const Box& a, const Box& b) {
  // Compare on the finer of both levels
  const int level = std::max(a.level, b.level);
  const auto apart = [level](std::int64_t p, int p_level, std::int64_t q, int q_level) {
    return ((p + 1) << (level - p_level)) < (q << (level - q_level));
  };
  return !apart(a.x, a.level, b.x, b.level) && !apart(b.x, b.level, a.x, a.level) &&
         !apart(a.y, a.level, b.y, b.level) && !apart(b.y, b.level, a.y, a.level);
}

// Walks the tree downwards; each box knows what still lies undecided around it
class Walk {
 public:
  Walk(const Quadtree& tree, InteractionLists& lists) : tree_(tree), lists_(lists) {}

  // `level_around`: boxes of the same level that touch this one, itself included;
  // `leaves_around`: wider leaves that touch it
  void visit(std::int32_t number, const std::vector<std::int32_t>& level_around,
             const std::vector<std::int32_t>& leaves_around) {
    const Box& box = tree_.boxes[number];
    if (box.leaf()) {
      for (const std::int32_t other : level_around)
        if (tree_.boxes[other].leaf()) add_near(number, other);
      for (const std::int32_t other : leaves_around) {
        add_near(number, other);
        add_near(other, number);
      }
      return;
    }
    for (std::int32_t c = 0; c < box.child_count; ++c)
      descend(box.first_child + c, level_around, leaves_around);
  }

  std::vector<std::vector<std::pair<int, BoxPair>>> translations;  // a level: offset and pair

 private:
  void descend(std::int32_t number, const std::vector<std::int32_t>& parents_around,
               const std::vector<std::int32_t>& leaves_around) {
    const Box& box = tree_.boxes[number];
    std::vector<std::int32_t> level_around, wider;
    for (const std::int32_t parent : parents_around) {
      const Box& other = tree_.boxes[parent];
      if (other.leaf()) {
        meet_leaf(number, parent, wider);
        continue;
      }
      for (std::int32_t s = other.first_child; s < other.first_child + other.child_count; ++s) {
        if (touch(box, tree_.boxes[s]))
          level_around.push_back(s);
        else
          translate(number, s);
      }
    }
    for (const std::int32_t leaf : leaves_around) meet_leaf(number, leaf, wider);
    visit(number, level_around, wider);
  }

  // A box and a wider leaf that its parent touches
  void meet_leaf(std::int32_t number, std::int32_t leaf, std::vector<std::int32_t>& wider) {
    const Box& box = tree_.boxes[number];
    if (touch(box, tree_.boxes[leaf])) {
      wider.push_back(leaf);
      return;
    }
    const bool direct = box.leaf() && std::max(box.sources(), box.targets()) <= kFewPoints;
    if (direct) {
      add_near(number, leaf);
      add_near(leaf, number);
    } else {
      if (box.sources() > 0 && tree_.boxes[leaf].targets() > 0)
        lists_.wide.push_back({leaf, number});
      if (box.targets() > 0 && tree_.boxes[leaf].sources() > 0)
        lists_.narrow.push_back({number, leaf});
    }
  }

  void add_near(std::int32_t target, std::int32_t source) {
    if (tree_.boxes[target].targets() > 0 && tree_.boxes[source].sources() > 0)
      lists_.near.push_back({target, source});
  }

  void translate(std::int32_t target, std::int32_t source) {
    const Box& t = tree_.boxes[target];
    const Box& s = tree_.boxes[source];
    if (t.targets() == 0 || s.sources() == 0) return;
    if (static_cast<int>(translations.size()) <= t.level) translations.resize(t.level + 1);
    translations[t.level].push_back({offset_number(s.x - t.x, s.y - t.y), {target, source}});
  }

  const Quadtree& tree_;
  InteractionLists& lists_;
};

bool by_target(const BoxPair& a, const BoxPair& b) {
  return a.target != b.target ? a.target < b.target : a.source < b.source;
}

// Sorts pairs by chunk of targets, offset, target
LevelTranslations in_chunks(const std::vector<std::pair<int, BoxPair>>& found, Index first_box,
                            Index box_count) {
  LevelTranslations result;
  const Index chunks = (box_count + kChunk - 1) / kChunk;
  const auto bin = [&](const std::pair<int, BoxPair>& entry) {
    return (entry.second.target - first_box) / kChunk * kOffsets + entry.first;
  };
  result.begin.assign(chunks * kOffsets + 1, 0);
  for (const std::pair<int, BoxPair>& entry : found) ++result.begin[bin(entry) + 1];
  for (std::size_t i = 1; i < result.begin.size(); ++i) result.begin[i] += result.begin[i - 1];
  std::vector<Index> next = result.begin;
  result.pairs.resize(found.size());
  for (const std::pair<int, BoxPair>& entry : found)
    result.pairs[next[bin(entry)]++] = entry.second;
  for (std::size_t i = 0; i + 1 < result.begin.size(); ++i)
    std::sort(result.pairs.begin() + result.begin[i], result.pairs.begin() + result.begin[i + 1],
              by_target);
  return result;
}

}  // namespace

InteractionLists::InteractionLists(const Quadtree& tree) {
  Walk walk(tree, *this);
  walk.translations.resize(tree.levels());
  walk.visit(0, {0}, {});
  for (int level = 0; level < tree.levels(); ++level)
    translations.push_back(
        in_chunks(walk.translations[level], tree.level_begin[level], tree.boxes_on(level)));
  std::sort(near.begin(), near.end(), by_target);
  std::sort(wide.begin(), wide.end(), by_target);
  std::sort(narrow.begin(), narrow.end(), by_target);
}

}  // namespace floe::fmm::multipole
