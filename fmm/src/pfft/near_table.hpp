#pragma once

#include "pfft/grid.hpp"

#include <floe/fmm/radial_kernel.hpp>

#include <vector>

namespace floe::fmm::pfft {

/// Cells around a cell whose pairs the fit looks at.
inline int fitted_reach(int stencil, int near_radius) { return near_radius + stencil; }

/// Replaces the real part of the kernel's table (nx × ny offsets ≥ 0, x fastest) at offsets within
/// the near radius. Near pairs are corrected exactly, so these real parts are free; but stencils of
/// far pairs reach them, and what suits those best is not the singular kernel but a smooth cap
/// (F.6). They solve the least-squares problem that the grid be right for sampled pairs which are
/// not near.
void fit_near_table(const Grid& grid, const NearShape& near, const RadialKernel& kernel,
                    std::vector<Complex>& table);

}  // namespace floe::fmm::pfft
