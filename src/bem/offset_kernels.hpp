#pragma once

#include <floe/bem/element_integrals.hpp>
#include <floe/green/green_table.hpp>
#include <floe/mesh/q8_mesh.hpp>

namespace floe::bem {

/// Targets at all offsets (i + half_x/2, j + half_y/2) steps ≥ 0 from an element's centre.
struct OffsetGrid {
  double step_x, step_y;  ///< [m]
  Index nx, ny;
  bool half_x, half_y;
};

/// The integrals of one element, centred on the origin, at those targets: row = local node, column
/// i + nx·j. The rules are those of ElementIntegrals.
using OffsetKernels = Eigen::Matrix<Complex, 8, Eigen::Dynamic>;
OffsetKernels offset_kernels(const mesh::Q8Mesh& element, double tolerance, const OffsetGrid& grid,
                             const green::GreenTable& green);

}  // namespace floe::bem
