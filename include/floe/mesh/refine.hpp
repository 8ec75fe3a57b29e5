#pragma once

#include <floe/mesh/q8_mesh.hpp>

namespace floe::mesh {

/// The same surface with every element divided into four at its centre and the middles of its
/// sides, in parametric coordinates: curved elements keep their shape exactly. Nodes of the coarse
/// mesh keep their numbers; the four parts of an element follow one another.
/// Throws MeshError where Q8Mesh does.
Q8Mesh refine(const Q8Mesh& mesh);

}  // namespace floe::mesh
