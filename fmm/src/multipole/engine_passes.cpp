#include "multipole/engine.hpp"

namespace floe::fmm::multipole {
namespace {

constexpr Index kChunk = 64;  // boxes a task

// y_t += M x_s for a list of boxes, all columns; numbers of boxes within their levels
template <class Real>
class PairProduct {
 public:
  PairProduct(const AlignedArray<Real>& matrix, const Expansions<Real>& x, Expansions<Real>& y)
      : matrix_(matrix), x_(x), y_(y) {}

  void add(Index target, Index source) {
    target_[count_] = target;
    source_[count_++] = source;
    if (count_ == kTile) flush();
  }

  // NOTE: a list that does not fill the last tile repeats a source and throws its product away, so
  // that a box is summed by the same instructions wherever it stands in the list
  void flush() {
    if (count_ == 0) return;
    if (count_ < kTile) waste_.resize(static_cast<std::size_t>(2 * y_.stride));
    for (Index column = 0; column < x_.columns; ++column) {
      const Real* from[kTile];
      Real* to[kTile];
      for (int b = 0; b < kTile; ++b) {
        from[b] = x_.at(source_[b < count_ ? b : 0], column);
        to[b] = b < count_ ? y_.at(target_[b], column) : waste_.data();
      }
      multiply_add(matrix_.data(), y_.stride, x_.rank, x_.stride, from, to);
    }
    count_ = 0;
  }

 private:
  const AlignedArray<Real>& matrix_;
  const Expansions<Real>& x_;
  Expansions<Real>& y_;
  Index target_[kTile] = {}, source_[kTile] = {};
  int count_ = 0;
  std::vector<Real> waste_;
};

int child_number(const Box& box) { return (box.x & 1) + 2 * (box.y & 1); }

}  // namespace

template <class Real>
typename TypedEngine<Real>::Levels TypedEngine<Real>::make_levels(Index columns) const {
  Levels levels(matrices_.size());
  for (std::size_t level = kTopLevel; level < matrices_.size(); ++level)
    levels[level] = Expansions<Real>(geometry_.tree.boxes_on(static_cast<int>(level)), columns,
                                     matrices_[level].rank, matrices_[level].stride);
  return levels;
}

template <class Real>
void TypedEngine<Real>::form_leaf_moments(const Columns<Real>& charges, Levels& moments) const {
  const Quadtree& tree = geometry_.tree;
#pragma omp parallel for schedule(dynamic, kChunk)
  for (Index b = tree.level_begin[kTopLevel]; b < tree.level_begin.back(); ++b) {
    const Box& box = tree.boxes[b];
    if (!box.leaf()) continue;
    Expansions<Real>& level = moments[box.level];
    for (Index column = 0; column < level.columns; ++column)
      spread_rows(source_weights_.data() + source_start_[b], box.sources(), level.stride,
                  charges.real(column) + box.source_begin, charges.imag(column) + box.source_begin,
                  level.at(b - tree.level_begin[box.level], column));
  }
}

template <class Real>
void TypedEngine<Real>::shift_to_parents(Levels& moments) const {
  const Quadtree& tree = geometry_.tree;
  for (int level = tree.levels() - 2; level >= kTopLevel; --level) {
    const Index first = tree.level_begin[level], last = tree.level_begin[level + 1];
#pragma omp parallel for schedule(dynamic, 1)
    for (Index chunk = first; chunk < last; chunk += kChunk)
      for (int number = 0; number < 4; ++number) {
        PairProduct<Real> product(matrices_[level].up[number], moments[level + 1], moments[level]);
        for (Index b = chunk; b < std::min(chunk + kChunk, last); ++b)
          for (Index c = tree.boxes[b].first_child;
               c < tree.boxes[b].first_child + tree.boxes[b].child_count; ++c)
            if (child_number(tree.boxes[c]) == number && tree.boxes[c].sources() > 0)
              product.add(b - first, c - last);
        product.flush();
      }
  }
}

template <class Real>
void TypedEngine<Real>::translate_across_lists(const Levels& moments, Levels& locals) const {
  const Quadtree& tree = geometry_.tree;
  for (int level = kTopLevel; level < tree.levels(); ++level) {
    const LevelTranslations& lists = geometry_.lists.translations[level];
    const Index first = tree.level_begin[level];
#pragma omp parallel for schedule(dynamic, 1)
    for (Index chunk = 0; chunk < lists.chunks(); ++chunk)
      for (int offset = 0; offset < kOffsets; ++offset) {
        PairProduct<Real> product(matrices_[level].across[offset], moments[level], locals[level]);
        const Index bin = chunk * kOffsets + offset;
        for (Index p = lists.begin[bin]; p < lists.begin[bin + 1]; ++p)
          product.add(lists.pairs[p].target - first, lists.pairs[p].source - first);
        product.flush();
      }
  }
}

template <class Real>
void TypedEngine<Real>::couple_at_the_top(const Levels& moments, Levels& locals) const {
  // Multiply the moments by i: Im G enters the sum as i Im G
  const Quadtree& tree = geometry_.tree;
  const Expansions<Real>& from = moments[kTopLevel];
  const Index first = tree.level_begin[kTopLevel], count = tree.boxes_on(kTopLevel);
  Expansions<Real> turned(count, from.columns, from.rank, from.stride);
  for (Index b = 0; b < count; ++b)
    for (Index column = 0; column < from.columns; ++column)
      for (Index i = 0; i < from.stride; ++i) {
        turned.at(b, column)[i] = -from.at(b, column)[from.stride + i];
        turned.at(b, column)[from.stride + i] = from.at(b, column)[i];
      }
#pragma omp parallel for schedule(dynamic, 1)
  for (Index t = 0; t < count; ++t)
    for (Index s = 0; s < count; ++s) {
      const Box& target = tree.boxes[first + t];
      const Box& source = tree.boxes[first + s];
      PairProduct<Real> product(top_[offset_number(source.x - target.x, source.y - target.y)],
                                turned, locals[kTopLevel]);
      product.add(t, s);
      product.flush();
    }
}

template <class Real>
void TypedEngine<Real>::add_wide_sources(const Columns<Real>& charges, Levels& locals) const {
  const Quadtree& tree = geometry_.tree;
  const auto groups = static_cast<Index>(narrow_groups_.size());
#pragma omp parallel for schedule(dynamic, 16)
  for (Index group = 0; group < groups; ++group)
    for (Index p = narrow_groups_[group].first; p < narrow_groups_[group].second; ++p) {
      const BoxPair& pair = geometry_.lists.narrow[p];
      const Box& box = tree.boxes[pair.target];
      const Box& source = tree.boxes[pair.source];
      Expansions<Real>& level = locals[box.level];
      for (Index column = 0; column < level.columns; ++column)
        spread_rows(narrow_.data() + narrow_start_[p], source.sources(), level.stride,
                    charges.real(column) + source.source_begin,
                    charges.imag(column) + source.source_begin,
                    level.at(pair.target - tree.level_begin[box.level], column));
    }
}

template <class Real>
void TypedEngine<Real>::shift_to_children(Levels& locals) const {
  const Quadtree& tree = geometry_.tree;
  for (int level = kTopLevel; level + 1 < tree.levels(); ++level) {
    const Index first = tree.level_begin[level], last = tree.level_begin[level + 1];
#pragma omp parallel for schedule(dynamic, 1)
    for (Index chunk = first; chunk < last; chunk += kChunk)
      for (int number = 0; number < 4; ++number) {
        PairProduct<Real> product(matrices_[level].down[number], locals[level], locals[level + 1]);
        for (Index b = chunk; b < std::min(chunk + kChunk, last); ++b)
          for (Index c = tree.boxes[b].first_child;
               c < tree.boxes[b].first_child + tree.boxes[b].child_count; ++c)
            if (child_number(tree.boxes[c]) == number && tree.boxes[c].targets() > 0)
              product.add(c - last, b - first);
        product.flush();
      }
  }
}

template <class Real>
void TypedEngine<Real>::evaluate_at_targets(const Levels& moments, const Levels& locals,
                                            Columns<Real>& potentials) const {
  const Quadtree& tree = geometry_.tree;
  const AlignedArray<Real>& weights = tree.same_points ? source_weights_ : target_weights_;
  const std::vector<Index>& start = tree.same_points ? source_start_ : target_start_;
#pragma omp parallel for schedule(dynamic, kChunk)
  for (Index b = tree.level_begin[kTopLevel]; b < tree.level_begin.back(); ++b) {
    const Box& box = tree.boxes[b];
    if (!box.leaf()) continue;
    const Expansions<Real>& level = locals[box.level];
    for (Index column = 0; column < level.columns; ++column) {
      const Real* local = level.at(b - tree.level_begin[box.level], column);
      row_products(weights.data() + start[b], box.targets(), level.stride, local,
                   local + level.stride, potentials.real(column) + box.target_begin,
                   potentials.imag(column) + box.target_begin);
    }
  }

  // Narrow boxes act on wider leaves by their moments
  const auto groups = static_cast<Index>(wide_groups_.size());
#pragma omp parallel for schedule(dynamic, 16)
  for (Index group = 0; group < groups; ++group)
    for (Index p = wide_groups_[group].first; p < wide_groups_[group].second; ++p) {
      const BoxPair& pair = geometry_.lists.wide[p];
      const Box& target = tree.boxes[pair.target];
      const Box& box = tree.boxes[pair.source];
      const Expansions<Real>& level = moments[box.level];
      for (Index column = 0; column < level.columns; ++column) {
        const Real* moment = level.at(pair.source - tree.level_begin[box.level], column);
        row_products(wide_.data() + wide_start_[p], target.targets(), level.stride, moment,
                     moment + level.stride, potentials.real(column) + target.target_begin,
                     potentials.imag(column) + target.target_begin);
      }
    }
}

template class TypedEngine<float>;
template class TypedEngine<double>;

}  // namespace floe::fmm::multipole
