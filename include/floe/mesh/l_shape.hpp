#pragma once

#include <floe/mesh/q8_mesh.hpp>

namespace floe::mesh {

struct LShapeOptions {
  double length = 0.0;        ///< extent in x [m]
  double width = 0.0;         ///< extent in y [m]
  double cut_length = 0.0;    ///< extent in x of the rectangle that is missing at +x, +y [m]
  double cut_width = 0.0;     ///< extent in y of it [m]
  double element_size = 0.0;  ///< no element edge is longer [m]
};

/// Mesh of an L: the rectangle without the one at its upper right corner, the whole centred on the
/// origin, of equal elements whose sides go into all four lengths. Throws InputError on a size that
/// is not positive, a cut that is not smaller than the rectangle, lengths that have no common
/// element side between half the element size and the whole (or down to 1/64 of the extent), and on
/// more than 1e8 elements.
Q8Mesh make_l_shape(const LShapeOptions& options);

}  // namespace floe::mesh
