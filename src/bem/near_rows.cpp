#include "bem/near_rows.hpp"

namespace floe::bem {

NearRow::NearRow(const NearPattern& pattern, const ElementIntegrals& integrals,
                 const SourceRule& rule, const fmm::KernelSum& sum, const green::GreenTable& green)
    : pattern_(pattern),
      integrals_(integrals),
      rule_(rule),
      sum_(sum),
      green_(green),
      entry_of_node_(integrals.mesh().node_count()),
      near_mark_(rule.points().cols(), 0),
      weight_(8 * static_cast<std::size_t>(rule.points_per_element())) {}

const std::vector<Complex>& NearRow::values(Index block, Index row,
                                            const std::vector<std::array<Complex, 8>>& exact) {
  place_columns(block, row);
  const std::size_t begin = pattern_.pair_begin(row), end = pattern_.pair_begin(row + 1);
  elements_.assign(pattern_.pair_element() + begin, pattern_.pair_element() + end);
  add_exact(row, exact);
  subtract_sources(row);
  return values_;
}

void NearRow::place_columns(Index block, Index row) {
  const auto columns = pattern_.columns(block);
  const std::size_t begin = pattern_.entry_begin(row), end = pattern_.entry_begin(row + 1);
  values_.assign(end - begin, Complex(0.0, 0.0));
  for (std::size_t k = begin; k < end; ++k)
    entry_of_node_[columns[pattern_.entry_column()[k]]] = static_cast<std::int32_t>(k - begin);
}

void NearRow::add_exact(Index row, const std::vector<std::array<Complex, 8>>& exact) {
  const std::size_t begin = pattern_.pair_begin(row);
  integral_.resize(elements_.size());
  if (exact.empty())
    integrals_.node_elements(pattern_.target(row), elements_, green_, integral_);
  else
    for (std::size_t k = 0; k < elements_.size(); ++k)
      integral_[k] = exact[pattern_.pair_kind()[begin + k]];
  for (std::size_t k = 0; k < elements_.size(); ++k)
    for (int m = 0; m < 8; ++m)
      values_[entry_of_node_[integrals_.mesh().elements()(m, elements_[k])]] += integral_[k][m];
}

void NearRow::subtract_sources(Index row) {
  // List the source points of all near elements; nodes that elements share are listed once
  const int per_element = rule_.points_per_element();
  points_.clear();
  if (rule_.at_nodes()) {
    points_.resize(values_.size());
    for (const Index element : elements_)
      for (int p = 0; p < per_element; ++p) {
        const Index node = rule_.point(element, p);
        points_[entry_of_node_[node]] = node;
      }
  } else {
    for (const Index element : elements_)
      for (int p = 0; p < per_element; ++p) points_.push_back(rule_.point(element, p));
  }
  evaluate_sources(pattern_.target(row));

  // Take away what the points give
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    rule_.fill_weights(elements_[k], weight_.data());
    std::array<Complex, 8> sum{};
    for (int p = 0; p < per_element; ++p) {
      const std::size_t slot =
          rule_.at_nodes() ? entry_of_node_[rule_.point(elements_[k], p)] : k * per_element + p;
      for (int m = 0; m < 8; ++m) sum[m] += weight_[8 * p + m] * point_value_[slot];
    }
    for (int m = 0; m < 8; ++m)
      values_[entry_of_node_[integrals_.mesh().elements()(m, elements_[k])]] -= sum[m];
  }
}

// What the engine gives for each source point: near ones its far value, others the kernel
void NearRow::evaluate_sources(Index target) {
  const auto mark = static_cast<std::int32_t>(target + 1);
  for (const Index source : sum_.near_sources(target)) near_mark_[source] = mark;
  near_points_.clear();
  near_slot_.clear();
  far_slot_.clear();
  distance_.clear();
  point_value_.assign(points_.size(), Complex(0.0, 0.0));
  const Point2 position = integrals_.mesh().nodes().col(target);
  for (std::size_t slot = 0; slot < points_.size(); ++slot) {
    if (near_mark_[points_[slot]] == mark) {
      near_points_.push_back(points_[slot]);
      near_slot_.push_back(slot);
      continue;
    }
    // NOTE: an engine without near pairs leaves coincident points out
    const double distance = (rule_.points().col(points_[slot]) - position).norm();
    if (distance == 0.0) continue;
    distance_.push_back(distance);
    far_slot_.push_back(slot);
  }
  near_value_.resize(near_points_.size());
  far_value_.resize(distance_.size());
  sum_.far_values(target, near_points_, near_value_);
  green_.evaluate(distance_, far_value_);
  for (std::size_t k = 0; k < near_slot_.size(); ++k) point_value_[near_slot_[k]] = near_value_[k];
  for (std::size_t k = 0; k < far_slot_.size(); ++k) point_value_[far_slot_[k]] = far_value_[k];
}

}  // namespace floe::bem
