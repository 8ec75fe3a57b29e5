#include "bem/near_rows.hpp"

namespace floe::bem {

NearRow::NearRow(const NearSetup& setup)
    : setup_(setup),
      coefficient_(SingularFunctions::coefficients(setup.green.exact().nu())),
      rest_at_zero_(SingularFunctions::rest_at_zero(setup.green.exact())),
      entry_of_node_(setup.integrals.mesh().node_count()),
      point_value_(setup.rule.points_per_element()) {}

const std::vector<double>& NearRow::from_moments(Index row) {
  setup_.moments.combine(row, coefficient_, values_);
  return values_;
}

const std::vector<double>& NearRow::integrated(Index block, Index row) {
  const NearPattern& pattern = setup_.pattern;
  const SourceRule& rule = setup_.rule;
  const mesh::Q8Mesh& mesh = setup_.integrals.mesh();
  const Index target = pattern.target(row);
  pattern.place_entries(block, row, entry_of_node_);
  values_.assign(pattern.entry_begin(row + 1) - pattern.entry_begin(row), 0.0);
  const auto near = pattern.near_elements(row);
  elements_.assign(near.begin(), near.end());
  integral_.resize(elements_.size());
  setup_.integrals.node_elements(target, elements_, setup_.green, integral_);
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    // Take out what the source points give for it
    for (int p = 0; p < rule.points_per_element(); ++p) {
      const double r =
          (rule.points().col(rule.point(elements_[k], p)) - mesh.nodes().col(target)).norm();
      point_value_[p] = rest_at_zero_;
      if (r > 0.0) setup_.green.evaluate({&r, 1}, {&point_value_[p], 1});
    }
    std::array<Complex, 8> by_points;
    rule.collect(elements_[k], point_value_.data(), by_points.data());
    for (int m = 0; m < 8; ++m)
      values_[entry_of_node_[mesh.elements()(m, elements_[k])]] +=
          integral_[k][m].real() - by_points[m].real();
  }
  return values_;
}

double NearRow::squared_integrals() const {
  double sum = 0.0;
  for (const auto& integral : integral_)
    for (const Complex& value : integral) sum += std::norm(value);
  return sum;
}

}  // namespace floe::bem
