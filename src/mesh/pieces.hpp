#pragma once

#include "mesh/half_edges.hpp"

#include <floe/mesh/q8_mesh.hpp>

#include <span>
#include <vector>

namespace floe::mesh {

/// Connected components of a mesh, numbered in the order of their first element.
struct Pieces {
  int count = 0;
  std::vector<int> of_element;
  std::vector<int> of_node;
};

/// Elements are connected across shared edges. Throws MeshError where pieces share a node but no
/// edge: a joint of no width, whose stiffness would be that of the mesh and not of the plate.
Pieces find_pieces(const Points2& nodes, const Connectivity& elements,
                   std::span<const HalfEdge> half_edges, const MeshLabels& labels);

}  // namespace floe::mesh
