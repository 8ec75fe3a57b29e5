#pragma once

#include <floe/fmm/radial_kernel.hpp>
#include <floe/numeric/types.hpp>

#include <limits>
#include <memory>
#include <vector>

namespace floe::fmm {

struct PfftOptions {
  /// Relative error ‖u - u*‖₂ / ‖u*‖₂ asked of a sum, 1e-7 … 1e-2. Held for charges without
  /// any order, the worst case; smooth charges come out better.
  double tolerance = 1e-4;
  /// Largest wavenumber of the kernels that will use the plan [rad/m].
  double max_wavenumber = 0.0;
  /// A kernel of the sweep, that of the longest wave, reaching all distances; a view, needed while
  /// the plan is made. Errors are those of the part 2/R; where a wave makes the sums larger than
  /// 2/R alone, a cheaper design keeps the tolerance. Without it the plan expects no wave.
  const RadialKernel* typical_kernel = nullptr;
  /// Memory that the plan and one sum may take [byte].
  double memory_budget = std::numeric_limits<double>::infinity();
};

/// What the design chose: lengths of a stencil in grid points and of the near radius in spacings,
/// and what they cost.
struct PfftDesign {
  int stencil = 0;           ///< points a direction, w
  double near_radius = 0.0;  ///< spacings, between the cells of two points
  double spacing = 0.0;      ///< of the grid [m]
  Index nx = 0, ny = 0;      ///< grid points along the longer and the shorter side
  double near_pairs = 0.0;   ///< (target, source) pairs that are corrected
  double memory = 0.0;       ///< of the plan and a sum [byte]
  double nanoseconds = 0.0;  ///< estimated for one application, one column, one thread
};

namespace pfft {
class Geometry;
}

/// The part of a pre-corrected FFT sum that does not depend on the kernel: grid, stencils and
/// near lists. Shared by the sums of a frequency sweep. Immutable.
class PfftPlan {
 public:
  /// Points are 2 × count [m]. Throws InputError when a coordinate is not finite or there is no
  /// point, BudgetError when grid or near lists would exceed the memory budget: for clustered
  /// points use another engine.
  PfftPlan(const Points2& sources, const Points2& targets, const PfftOptions& options = {});
  /// The same with stencil (2 to 8), radius (up to 9) and spacing prescribed, for measurements.
  PfftPlan(const Points2& sources, const Points2& targets, const PfftOptions& options,
           const PfftDesign& design);

  const PfftOptions& options() const { return options_; }
  const PfftDesign& design() const;
  /// Largest distance at which a sum evaluates its kernel [m]: tables should reach it.
  double max_distance() const;
  /// Those of every sum on this plan.
  std::vector<Index> near_sources(Index target) const;
  const pfft::Geometry& geometry() const { return *geometry_; }
  double memory() const;  ///< [byte]

 private:
  PfftOptions options_;
  std::shared_ptr<const pfft::Geometry> geometry_;
};

}  // namespace floe::fmm
