#pragma once

#include "bem/near_pattern.hpp"
#include "bem/source_rule.hpp"

#include <floe/bem/element_integrals.hpp>
#include <floe/fmm/kernel_sum.hpp>
#include <floe/green/green_table.hpp>

#include <array>
#include <vector>

namespace floe::bem {

/// Computes one row of the near matrix after the other; the scratch of one thread. Keeps views of
/// all that it is given.
class NearRow {
 public:
  NearRow(const NearPattern& pattern, const ElementIntegrals& integrals, const SourceRule& rule,
          const fmm::KernelSum& sum, const green::GreenTable& green);

  /// The entries of row `row`, which lies in `block`. `exact` has the integrals of each kind of
  /// pair, or is empty: then they are computed.
  const std::vector<Complex>& values(Index block, Index row,
                                     const std::vector<std::array<Complex, 8>>& exact);

 private:
  void place_columns(Index block, Index row);
  void add_exact(Index row, const std::vector<std::array<Complex, 8>>& exact);
  void subtract_sources(Index row);
  void evaluate_sources(Index target);

  const NearPattern& pattern_;
  const ElementIntegrals& integrals_;
  const SourceRule& rule_;
  const fmm::KernelSum& sum_;
  const green::GreenTable& green_;
  std::vector<std::int32_t> entry_of_node_;  // valid for the nodes of the present row
  std::vector<std::int32_t> near_mark_;      // target + 1 for which a source is near the engine
  std::vector<Complex> values_;
  std::vector<std::array<Complex, 8>> integral_;
  std::vector<Index> elements_, points_, near_points_;
  std::vector<std::size_t> near_slot_, far_slot_;
  std::vector<double> distance_, weight_;
  std::vector<Complex> point_value_, near_value_, far_value_;
};

}  // namespace floe::bem
