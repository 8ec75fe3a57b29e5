#pragma once

#include "bem/near_moments.hpp"
#include "bem/near_pattern.hpp"
#include "bem/source_rule.hpp"

#include <floe/bem/element_integrals.hpp>
#include <floe/green/green_table.hpp>

#include <array>
#include <vector>

namespace floe::bem {

/// All that the near matrix is made from; views.
struct NearSetup {
  const NearPattern& pattern;
  const NearMoments& moments;
  const ElementIntegrals& integrals;
  const SourceRule& rule;
  const green::GreenTable& green;
};

/// Computes rows of the near matrix in two ways; the scratch of one thread.
class NearRow {
 public:
  explicit NearRow(const NearSetup& setup);

  /// The entries of row `row` by the moments (F.23).
  const std::vector<double>& from_moments(Index row);

  /// The same, of a row that lies in `block`, with every near element integrated anew: tens of
  /// times slower.
  const std::vector<double>& integrated(Index block, Index row);

  /// Sum of |∫ G N dS|² over near elements of the row that was integrated last.
  double squared_integrals() const;

 private:
  const NearSetup& setup_;
  std::array<double, SingularFunctions::kCount> coefficient_;
  Complex rest_at_zero_;
  std::vector<std::int32_t> entry_of_node_;  // valid for the nodes of the present row
  std::vector<double> values_;
  std::vector<std::array<Complex, 8>> integral_;
  std::vector<Index> elements_;
  std::vector<Complex> point_value_;
};

}  // namespace floe::bem
