#pragma once

#include <floe/mesh/q8_mesh.hpp>

namespace floe::mesh {

/// How good a mesh is to compute on. Elements are 0-based; where several are equally bad the first
/// one is named.
struct MeshQuality {
  /// Length of the shortest and of the longest element edge, corner to middle to corner [m].
  double shortest_edge = 0.0;
  double longest_edge = 0.0;
  Index shortest_edge_element = 0;
  Index longest_edge_element = 0;

  /// Largest ratio of the two principal stretches of an element at its centre (the singular values
  /// of its Jacobian): a/b for an a × b rectangle, 1 for a square; large too for a flat rhombus.
  double worst_aspect_ratio = 1.0;
  Index worst_aspect_element = 0;

  /// Smallest ratio min det J / max det J over an element's 3 × 3 Gauss points: 1 for a
  /// parallelogram, towards 0 for one that nearly folds.
  double worst_jacobian_ratio = 1.0;
  Index worst_jacobian_element = 0;

  /// Largest ratio of the depths of two elements that share an edge, where depth is area over the
  /// length of that edge: 1 where elements go on equally, 2 where they double.
  double largest_edge_jump = 1.0;
  Index edge_jump_element = 0;    ///< the deeper of the two
  Index edge_jump_neighbour = 0;  ///< the other; both 0 if no edge is shared
};

/// Length of the longest edge of each element [m].
VecXd longest_edges(const Q8Mesh& mesh);

/// Looks at every element and every edge once.
MeshQuality measure_quality(const Q8Mesh& mesh);

}  // namespace floe::mesh
