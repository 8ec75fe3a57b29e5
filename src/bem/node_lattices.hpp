#pragma once

#include <floe/bem/element_lattice.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace floe::bem {

/// The three lattices on which the nodes of equal elements lie.
enum NodeLatticeNumber : int { kCorners, kHorizontalSides, kVerticalSides };
inline constexpr int kNodeLattices = 3;
/// Whether points of the lattice lie half a step off the corners.
inline constexpr std::array<bool, kNodeLattices> kHalfX{false, true, false};
inline constexpr std::array<bool, kNodeLattices> kHalfY{false, false, true};

/// A lattice of sources with one kernel (F.14). What a node's basis function has on its four sides
/// (two for mid-sides) enters with the sign of x, of y where the kernel is odd in it.
struct SourceKind {
  int lattice;
  bool odd_x, odd_y;
};
inline constexpr int kSources = 8;
/// Those of even kernels first: they are the lattices themselves.
inline constexpr std::array<SourceKind, kSources> kSource{{{kCorners, false, false},
                                                           {kHorizontalSides, false, false},
                                                           {kVerticalSides, false, false},
                                                           {kCorners, true, false},
                                                           {kCorners, false, true},
                                                           {kCorners, true, true},
                                                           {kHorizontalSides, false, true},
                                                           {kVerticalSides, true, false}}};

/// A node and its moment: the mean over the sides where elements can be of ±1 where one is.
struct OutlineNode {
  Index line, place;  ///< of its lattice
  Index node;
  double moment;
};

/// Beyond so many lines it is cheaper to transform all rows of the lattice.
inline constexpr std::size_t kMostLines = 16;

/// Nodes with a moment that is not that of the interior, line by line: along x or along y, of which
/// there are fewer; along x if there are more than kMostLines.
struct OutlineNodes {
  bool few_lines() const { return line.size() <= kMostLines; }

  bool lines_along_x = true;
  std::vector<Index> line;        ///< lines that hold nodes
  std::vector<Index> line_begin;  ///< first of the nodes of each, and their number
  std::vector<OutlineNode> node;
};

struct NodeLattice {
  Index nx = 0, ny = 0;
  std::vector<std::int32_t> node;  ///< at i + nx·j; -1 where there is none
};

/// Nodes by lattice place, and what the outline leaves of their basis functions.
struct NodeLattices {
  explicit NodeLattices(const ElementLattice& elements);

  /// [byte]
  double memory() const;

  std::array<NodeLattice, kNodeLattices> lattice;
  /// Of even kernels all nodes are sources; listed, with lines along x, are those with a moment
  /// other than 1. Of odd kernels only the listed ones are.
  std::array<OutlineNodes, kSources> outline;
};

}  // namespace floe::bem
