#include "multipole/near_rows.hpp"

#include <cmath>

namespace floe::fmm::multipole {

template <class Real>
NearRows<Real>::NearRows(const Geometry& geometry, const RadialKernel& kernel, bool stored)
    : geometry_(geometry), kernel_(kernel), groups_(target_groups(geometry.lists.near)) {
  if (!stored) return;
  start_.push_back(0);
  for (Index group = 0; group < groups(); ++group) {
    const BoxPair& pair = geometry.lists.near[groups_[group].first];
    start_.push_back(start_.back() + geometry.tree.boxes[pair.target].targets() * length(group));
  }
  values_ = AlignedArray<Real>(start_.back());
#pragma omp parallel for schedule(dynamic, 16)
  for (Index group = 0; group < groups(); ++group) fill(group, values_.data() + start_[group]);
}

template <class Real>
Index NearRows<Real>::length(Index group) const {
  Index count = 0;
  for (Index p = groups_[group].first; p < groups_[group].second; ++p)
    count += geometry_.tree.boxes[geometry_.lists.near[p].source].sources();
  return padded<Real>(count);
}

template <class Real>
void NearRows<Real>::fill(Index group, Real* rows) const {
  const Quadtree& tree = geometry_.tree;
  const std::vector<BoxPair>& near = geometry_.lists.near;
  const auto [first, last] = groups_[group];
  const Box& box = tree.boxes[near[first].target];
  const Index row_length = length(group);
  std::vector<double> distance(row_length, 1.0);
  std::vector<Complex> value(row_length);
  for (Index i = box.target_begin; i < box.target_end; ++i) {
    const double x = tree.targets(0, i), y = tree.targets(1, i);
    Index count = 0;
    for (Index p = first; p < last; ++p) {
      const Box& source = tree.boxes[near[p].source];
      for (Index j = source.source_begin; j < source.source_end; ++j, ++count) {
        const double dx = tree.sources(0, j) - x, dy = tree.sources(1, j) - y;
        distance[count] = std::sqrt(dx * dx + dy * dy);
      }
    }

    // NOTE: coincident points are asked for at any distance, and their value is dropped
    Real* row = rows + (i - box.target_begin) * row_length;
    for (Index j = 0; j < count; ++j) row[j] = distance[j] > 0.0 ? Real(1) : Real(0);
    for (Index j = 0; j < count; ++j)
      if (distance[j] == 0.0) distance[j] = tree.root_width;
    const auto size = static_cast<std::size_t>(count);
    kernel_.evaluate({distance.data(), size}, {value.data(), size});
    for (Index j = 0; j < count; ++j) row[j] *= static_cast<Real>(value[j].real());
    for (Index j = count; j < row_length; ++j) row[j] = Real(0);
  }
}

template <class Real>
void NearRows<Real>::add(Index group, const Real* charges, Index charge_stride, Index columns,
                         Real* potentials, Index potential_stride) const {
  const Quadtree& tree = geometry_.tree;
  const std::vector<BoxPair>& near = geometry_.lists.near;
  const auto [first, last] = groups_[group];
  const Box& box = tree.boxes[near[first].target];
  const Index row_length = length(group);
  thread_local std::vector<Real> evaluated, gathered;
  const Real* rows = values_.data() + (start_.empty() ? 0 : start_[group]);
  if (start_.empty()) {
    evaluated.resize(static_cast<std::size_t>(row_length * box.targets()));
    fill(group, evaluated.data());
    rows = evaluated.data();
  }

  // Bring the charges of all neighbours into one row
  gathered.resize(static_cast<std::size_t>(2 * columns * row_length));
  for (Index part = 0; part < 2 * columns; ++part) {
    Real* to = gathered.data() + part * row_length;
    Real* const end = to + row_length;
    for (Index p = first; p < last; ++p) {
      const Box& source = tree.boxes[near[p].source];
      const Real* from = charges + part * charge_stride;
      to = std::copy(from + source.source_begin, from + source.source_end, to);
    }
    std::fill(to, end, Real(0));
  }
  constexpr Index kRows = 8;  // stay in the first cache for all columns
  for (Index i = box.target_begin; i < box.target_end; i += kRows)
    for (Index column = 0; column < columns; ++column) {
      const Real* x = gathered.data() + 2 * column * row_length;
      Real* y = potentials + 2 * column * potential_stride + i;
      row_products(rows + (i - box.target_begin) * row_length, std::min(kRows, box.target_end - i),
                   row_length, x, x + row_length, y, y + potential_stride);
    }
}

template class NearRows<float>;
template class NearRows<double>;

}  // namespace floe::fmm::multipole
