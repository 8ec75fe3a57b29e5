#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace floe::bem {

/// Which (target node, element) pairs are near, and where their integrals go in the near matrix C
/// of (F.2). Near is an element whose centre is nearer than `radius` of its longest edges: it is
/// integrated exactly. Frequency-independent.
///
/// Rows are targets along a Z-curve, in blocks of kBlockRows; the columns of a block are collected
/// once, and its entries have 16-bit numbers into that list.
class NearPattern {
 public:
  static constexpr Index kBlockRows = 32;

  /// Throws BudgetError when a block of rows has more than 65536 columns.
  NearPattern(const mesh::Q8Mesh& mesh, double radius);

  Index rows() const { return static_cast<Index>(target_.size()); }
  Index blocks() const { return (rows() + kBlockRows - 1) / kBlockRows; }
  Index target(Index row) const { return target_[row]; }
  std::size_t entry_count() const { return entry_column_.size(); }

  /// Nodes that the rows of a block refer to.
  std::span<const std::int32_t> columns(Index block) const {
    return {columns_.data() + column_begin_[block],
            column_begin_[block + 1] - column_begin_[block]};
  }
  /// First entry of a row; `entry_begin(rows())` is their number.
  std::size_t entry_begin(Index row) const { return entry_begin_[row]; }
  const std::uint16_t* entry_column() const { return entry_column_.data(); }

  /// entry_of_node[n] = number of node n's entry in the row, from 0, for the nodes that it has.
  void place_entries(Index block, Index row, std::vector<std::int32_t>& entry_of_node) const;

  std::span<const std::int32_t> near_elements(Index row) const {
    return {pair_element_.data() + pair_begin_[row], pair_begin_[row + 1] - pair_begin_[row]};
  }

  /// For each near element the number of its equal pair: pairs with the same number have the same
  /// integrals. Empty where `kinds()` is.
  std::span<const std::int32_t> near_kinds(Index row) const {
    if (kinds_.empty()) return {};
    return {pair_kind_.data() + pair_begin_[row], pair_begin_[row + 1] - pair_begin_[row]};
  }

  /// One pair (node, element) of each kind; empty where hardly two pairs are equal.
  struct Pair {
    std::int32_t node, element;
  };
  const std::vector<Pair>& kinds() const { return kinds_; }

  double memory() const;  ///< [byte]

 private:
  void find_pairs(const mesh::Q8Mesh& mesh, double radius);
  void number_kinds(const mesh::Q8Mesh& mesh);
  void number_entries(const mesh::Q8Mesh& mesh);

  std::vector<std::int32_t> target_;
  std::vector<std::size_t> pair_begin_, entry_begin_, column_begin_;
  std::vector<std::int32_t> pair_element_, pair_kind_, columns_;
  std::vector<std::uint16_t> entry_column_;
  std::vector<Pair> kinds_;
};

}  // namespace floe::bem
