#pragma once

#include "pfft/grid.hpp"

namespace floe::fmm::pfft {

/// The rectangle of all points and their number, along the grid's axes.
struct Extent {
  Point2 low, high;
  bool exchanged;
};
Extent extent_of(const Points2& sources, const Points2& targets);

/// Grid of a given stencil and spacing at most `spacing`; the points of its longer side fill a
/// fast FFT length.
Grid make_grid(const Extent& extent, int stencil, double spacing);

/// Stencil, radius and spacing of least estimated time among those that keep the tolerance.
/// Throws BudgetError when it takes more memory than the budget.
PfftDesign choose_design(const Extent& extent, const Points2& sources, const Points2& targets,
                         const PfftOptions& options);

/// Fills in grid and near pairs of a design's stencil, radius and spacing, and what they cost.
void estimate_cost(const Extent& extent, const Points2& sources, const Points2& targets,
                   double tolerance, PfftDesign& design);

}  // namespace floe::fmm::pfft
