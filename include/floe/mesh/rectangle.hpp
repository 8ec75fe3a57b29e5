#pragma once

#include <floe/mesh/q8_mesh.hpp>

namespace floe::mesh {

struct RectangleOptions {
  double length = 0.0;  ///< extent in x [m]
  double width = 0.0;   ///< extent in y [m]
  int nx = 0;           ///< elements along x
  int ny = 0;           ///< elements along y
  /// Ratio of the longest element edge (in the middle) to the shortest (at the ends), 1 … 100:
  /// edges shrink geometrically towards all four sides. 1 makes all elements equal.
  double grading = 1.0;
};

/// Mesh of the rectangle, centred on the origin, edges along x and y. It has
/// (2 nx + 1)(2 ny + 1) - nx ny nodes. Nodes are numbered row by row from the lower left, elements
/// too; the mesh is symmetric about both axes to the last bit. Throws InputError on a size or count
/// that is not positive, and on more than 1e8 elements.
Q8Mesh make_rectangle(const RectangleOptions& options);

}  // namespace floe::mesh
