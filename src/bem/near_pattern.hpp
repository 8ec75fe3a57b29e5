#pragma once

#include "bem/source_rule.hpp"

#include <floe/mesh/q8_mesh.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace floe::bem {

/// Which (target node, element) pairs are near, and where their integrals go in the near matrix C
/// of (F.2). Near is an element whose centre is closer than `radius` of its longest edges, and one
/// of which a source point is near for the engine: C holds whole elements. Frequency-independent.
///
/// Rows are targets along a Z-curve, in blocks of kBlockRows; the columns of a block are collected
/// once, and its entries have 16-bit numbers into that list.
class NearPattern {
 public:
  static constexpr Index kBlockRows = 16;
  using NearSources = std::function<std::vector<Index>(Index target)>;

  /// Throws BudgetError when a block of rows has more than 65536 columns.
  NearPattern(const mesh::Q8Mesh& mesh, const SourceRule& rule, double radius,
              const NearSources& near_sources);

  Index rows() const { return static_cast<Index>(target_.size()); }
  Index blocks() const { return (rows() + kBlockRows - 1) / kBlockRows; }
  Index target(Index row) const { return target_[row]; }
  std::size_t entry_count() const { return entry_column_.size(); }
  std::size_t pair_count() const { return pair_element_.size(); }

  /// Nodes that the rows of a block refer to.
  std::span<const std::int32_t> columns(Index block) const {
    return {columns_.data() + column_begin_[block],
            column_begin_[block + 1] - column_begin_[block]};
  }
  /// First entry of a row; `entry_begin(rows())` is their number.
  std::size_t entry_begin(Index row) const { return entry_begin_[row]; }
  const std::uint16_t* entry_column() const { return entry_column_.data(); }

  /// Near elements of a row, and for each the number of its equal pair: pairs with the same number
  /// have the same integrals.
  std::size_t pair_begin(Index row) const { return pair_begin_[row]; }
  const std::int32_t* pair_element() const { return pair_element_.data(); }
  const std::int32_t* pair_kind() const { return pair_kind_.data(); }

  /// One pair (node, element) of each kind.
  struct Pair {
    std::int32_t node, element;
  };
  const std::vector<Pair>& kinds() const { return kinds_; }

  double memory() const;  ///< [byte]

 private:
  void find_pairs(const mesh::Q8Mesh& mesh, const SourceRule& rule, double radius,
                  const NearSources& near_sources);
  void number_kinds(const mesh::Q8Mesh& mesh);
  void number_entries(const mesh::Q8Mesh& mesh);

  std::vector<std::int32_t> target_;
  std::vector<std::size_t> pair_begin_, entry_begin_, column_begin_;
  std::vector<std::int32_t> pair_element_, pair_kind_, columns_;
  std::vector<std::uint16_t> entry_column_;
  std::vector<Pair> kinds_;
};

}  // namespace floe::bem
