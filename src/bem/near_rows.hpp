#pragma once

#include "bem/near_moments.hpp"
#include "bem/near_pattern.hpp"
#include "bem/source_rule.hpp"

#include <floe/bem/element_integrals.hpp>
#include <floe/fmm/kernel_sum.hpp>
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
  const fmm::KernelSum& sum;
  const green::GreenTable& green;
};

/// Computes rows of the near matrix in two ways; the scratch of one thread.
class NearRow {
 public:
  explicit NearRow(const NearSetup& setup);

  /// The entries of row `row`, which lies in `block`, by the moments (F.23).
  const std::vector<Complex>& from_moments(Index block, Index row);

  /// The same with every close element integrated anew: tens of times slower.
  const std::vector<Complex>& integrated(Index block, Index row);

  /// Sum of |∫ G N dS|² over close elements of the row that was integrated last.
  double squared_integrals() const;

 private:
  void start(Index block, Index row);
  void add_rest_at_zero(Index row);
  void add_integrals(Index row);
  void add_near_sources(Index row);
  void add_points(Index element);

  const NearSetup& setup_;
  std::array<double, SingularFunctions::kCount> coefficient_;
  Complex rest_at_zero_;
  std::vector<std::int32_t> entry_of_node_;  // valid for the nodes of the present row
  std::vector<Complex> values_;
  std::vector<Complex> source_value_;  // of each source, zero between two uses
  std::vector<std::array<Complex, 8>> integral_;
  std::vector<Index> elements_;
  std::vector<double> distance_;
  std::vector<Complex> point_value_, far_value_, kernel_value_;
};

}  // namespace floe::bem
