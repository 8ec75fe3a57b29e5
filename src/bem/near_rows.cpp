#include "bem/near_rows.hpp"

#include <algorithm>

namespace floe::bem {

NearRow::NearRow(const NearSetup& setup)
    : setup_(setup),
      coefficient_(SingularFunctions::coefficients(setup.green.exact().nu())),
      rest_at_zero_(SingularFunctions::rest_at_zero(setup.green.exact())),
      entry_of_node_(setup.integrals.mesh().node_count()),
      source_value_(setup.rule.points().cols()),
      point_value_(setup.rule.points_per_element()) {}

const std::vector<Complex>& NearRow::from_moments(Index block, Index row) {
  start(block, row);
  setup_.moments.combine(row, coefficient_, values_);
  add_rest_at_zero(row);
  add_near_sources(row);
  return values_;
}

const std::vector<Complex>& NearRow::integrated(Index block, Index row) {
  start(block, row);
  add_integrals(row);
  add_near_sources(row);
  return values_;
}

double NearRow::squared_integrals() const {
  double sum = 0.0;
  for (const auto& integral : integral_)
    for (const Complex& value : integral) sum += std::norm(value);
  return sum;
}

void NearRow::start(Index block, Index row) {
  const NearPattern& pattern = setup_.pattern;
  pattern.place_entries(block, row, entry_of_node_);
  values_.assign(pattern.entry_begin(row + 1) - pattern.entry_begin(row), Complex(0.0, 0.0));
}

// What the smooth rest of G gives for a source point that coincides with the target
void NearRow::add_rest_at_zero(Index row) {
  const SourceRule& rule = setup_.rule;
  if (!rule.at_nodes()) return;
  const Index target = setup_.pattern.target(row);
  for (const std::int32_t element : setup_.pattern.close_elements(row)) {
    bool holds_target = false;
    for (int p = 0; p < rule.points_per_element(); ++p) {
      point_value_[p] = rule.point(element, p) == target ? rest_at_zero_ : 0.0;
      holds_target = holds_target || rule.point(element, p) == target;
    }
    if (holds_target) add_points(element);
  }
}

// Exact integrals over close elements minus G at their source points
void NearRow::add_integrals(Index row) {
  const Index target = setup_.pattern.target(row);
  const Point2 position = setup_.integrals.mesh().nodes().col(target);
  const SourceRule& rule = setup_.rule;
  const auto close = setup_.pattern.close_elements(row);
  elements_.assign(close.begin(), close.end());
  integral_.resize(elements_.size());
  setup_.integrals.node_elements(target, elements_, setup_.green, integral_);
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    for (int m = 0; m < 8; ++m)
      values_[entry_of_node_[setup_.integrals.mesh().elements()(m, elements_[k])]] +=
          integral_[k][m];
    for (int p = 0; p < rule.points_per_element(); ++p) {
      const double r = (rule.points().col(rule.point(elements_[k], p)) - position).norm();
      point_value_[p] = 0.0;
      if (r > 0.0) setup_.green.evaluate({&r, 1}, {&point_value_[p], 1});
      point_value_[p] = -point_value_[p];
    }
    add_points(elements_[k]);
  }
}

// G for the sources near the engine, minus what its far part gives for them
void NearRow::add_near_sources(Index row) {
  const Index target = setup_.pattern.target(row);
  const Point2 position = setup_.integrals.mesh().nodes().col(target);
  const std::vector<Index> sources = setup_.sum.near_sources(target);
  distance_.resize(sources.size());
  far_value_.resize(sources.size());
  kernel_value_.resize(sources.size());
  setup_.sum.far_values(target, sources, far_value_);
  for (std::size_t k = 0; k < sources.size(); ++k)
    distance_[k] = (setup_.rule.points().col(sources[k]) - position).norm();
  // NOTE: coincident points have no kernel value: any distance will do
  const auto coincident = std::find(distance_.begin(), distance_.end(), 0.0);
  if (coincident != distance_.end()) *coincident = setup_.green.max_distance();
  setup_.green.evaluate(distance_, kernel_value_);
  if (coincident != distance_.end()) kernel_value_[coincident - distance_.begin()] = 0.0;

  for (std::size_t k = 0; k < sources.size(); ++k)
    source_value_[sources[k]] = kernel_value_[k] - far_value_[k];
  for (const std::int32_t element : setup_.pattern.near_elements(row)) {
    bool any = false;
    for (int p = 0; p < setup_.rule.points_per_element(); ++p) {
      point_value_[p] = source_value_[setup_.rule.point(element, p)];
      any = any || point_value_[p] != Complex(0.0, 0.0);
    }
    if (any) add_points(element);
  }
  for (const Index source : sources) source_value_[source] = 0.0;
}

// Adds point_value_ through the shape functions of an element
void NearRow::add_points(Index element) {
  std::array<Complex, 8> sum;
  setup_.rule.collect(element, point_value_.data(), sum.data());
  for (int m = 0; m < 8; ++m)
    values_[entry_of_node_[setup_.integrals.mesh().elements()(m, element)]] += sum[m];
}

}  // namespace floe::bem
