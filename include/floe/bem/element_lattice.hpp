#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <optional>

namespace floe::bem {

/// A mesh whose elements are equal rectangles, parallel to the axes, on one lattice of cells; cells
/// may be empty (outlines, holes, gaps, several modules).
struct ElementLattice {
  /// Rows of `connectivity`: corners (-,-), (+,-), (+,+), (-,+), the middles of the lower and upper
  /// side, the middles of the left and right side, whatever the numbering of the mesh.
  enum Local : int { kCorner00, kCorner10, kCorner11, kCorner01, kLower, kUpper, kLeft, kRight };

  double step_x = 0.0, step_y = 0.0;             ///< edges of an element [m]
  Index nx = 0, ny = 0;                          ///< cells of the bounding rectangle
  Eigen::Matrix<Index, 2, Eigen::Dynamic> cell;  ///< (i, j) of each element, from 0
  mesh::Connectivity connectivity;               ///< node of each element by Local

  /// Share of the cells that hold an element.
  double filling() const {
    return static_cast<double>(cell.cols()) / (static_cast<double>(nx) * static_cast<double>(ny));
  }
};

/// The lattice of a mesh, or nothing if its elements are not equal, not parallel to the axes, or
/// not on one lattice, to 1e-9 of an edge (plus the rounding of the coordinates).
std::optional<ElementLattice> find_element_lattice(const mesh::Q8Mesh& mesh);

/// The same, or MeshError that says what a lattice is.
ElementLattice require_element_lattice(const mesh::Q8Mesh& mesh);

}  // namespace floe::bem
