#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace floe::mesh {

/// What a picture of a mesh needs: some of its nodes, flat triangles between them, the outline.
struct Drawing {
  std::vector<Index> nodes;                             ///< of the mesh, rising
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< positions in `nodes`, turning left
  std::vector<std::array<std::uint32_t, 2>> outline;    ///< edges that belong to one element
};

/// Six triangles an element. A mesh of more than `most_nodes` nodes is thinned out: of the nodes in
/// one cell of a square grid one stands for all, one on the outline where there is any, so that a
/// value at a drawn node is a value of the mesh. Pieces stay apart. About `most_nodes` are left.
Drawing make_drawing(const Q8Mesh& mesh, Index most_nodes);

}  // namespace floe::mesh
