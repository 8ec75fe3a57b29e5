#pragma once

#include <floe/mesh/q8_mesh.hpp>

namespace floe::mesh {

struct ModuleArrayOptions {
  double module_length = 0.0;  ///< extent of one module in x [m]
  double module_width = 0.0;   ///< extent of one module in y [m]
  int modules_x = 0;           ///< modules along x
  int modules_y = 0;           ///< modules along y
  double gap = 0.0;            ///< water between neighbours, in x and in y [m]
  double element_size = 0.0;   ///< no element edge is longer [m]
};

/// Mesh of equal rectangular modules in rows and columns, centred on the origin, separate pieces
/// of equal elements. Where a side of up to a fifth less than the largest allowed goes into the gap
/// too, it is taken: then all elements lie on one lattice. Nodes and elements are numbered module
/// by module, row by row from the lower left. Throws InputError on a size or count that is not
/// positive, and on more than 1e8 elements.
Q8Mesh make_module_array(const ModuleArrayOptions& options);

}  // namespace floe::mesh
