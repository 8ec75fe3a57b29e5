#pragma once

#include <floe/mesh/q8_mesh.hpp>

namespace floe::mesh {

/// Checks of a mesh's raw arrays, one rule after the other, in the order of the constructor of
/// Q8Mesh. Each throws MeshError naming the first ten culprits by their labels.

/// There are elements; coordinates are finite and within 1e9 m; indices are in range and not
/// repeated within an element; every node is used; the extent is at least 1e-6 m and 1e-7 of the
/// largest coordinate.
void check_arrays(const Points2& nodes, const Connectivity& elements, const MeshLabels& labels);

/// Turns clockwise elements, demands det J > 0 at every 3 × 3 Gauss point, and returns the number
/// of turned elements.
Index orient_elements(const Points2& nodes, Connectivity& elements, const MeshLabels& labels);

/// Distance below which two points count as one [m]: 1e-6 of `size`, but at most 1e-3 of the median
/// element, so that small floats far apart are not taken for single points.
double merge_tolerance(const Points2& nodes, const Connectivity& elements, double size);

/// No two nodes lie closer than `tolerance`.
void check_coincident_nodes(const Points2& nodes, double tolerance, const MeshLabels& labels);

}  // namespace floe::mesh
