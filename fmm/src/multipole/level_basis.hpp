#pragma once

#include <floe/fmm/radial_kernel.hpp>
#include <floe/numeric/types.hpp>

#include <vector>

namespace floe::fmm::multipole {

/// The functions through which the boxes of one level are seen from afar. A charge at y acts on x
/// outside the box and its neighbours like charges at a few skeleton points s (F.11),
///   G(|x - y|) ≈ Σ_s G(|x - s|) t_s(y),
/// and those like the r numbers m = restrict · t(y), t ≈ expand · m, the directions of least loss
/// for charges spread evenly over the box (F.12). All real, coordinates relative to the centre.
struct LevelBasis {
  double width = 0.0;      ///< of a box [m]
  Points2 skeleton;        ///< 2 × skeleton points
  MatXd expand, restrict;  ///< skeleton × r, r × skeleton
  int nodes = 0;  ///< Chebyshev nodes a side that t is interpolated from; 0: from the children
  MatXd from_candidates;  ///< t at the Chebyshev nodes, or at the skeletons of the four children
  Index rank() const { return expand.cols(); }
};

/// Bases of consecutive levels, the finest last.
using Bases = std::vector<LevelBasis>;

/// Builds the bases of boxes of widths `width`, `width`/2 … (`levels` of them, and more when the
/// last is too wide to be interpolated on nodes) for fields up to the distance `reach`, each
/// with a loss of about `tolerance` relative to the field of one charge.
Bases make_bases(const RadialKernel& kernel, double width, int levels, double reach,
                 double tolerance);

/// t(y) of the points y (2 × count, relative to the centre) on a level: skeleton × count.
MatXd skeleton_weights(const Bases& bases, std::size_t level, const Points2& points);

/// Centre of child 0 … 3 relative to that of a box of width `width`.
Point2 child_centre(int child, double width);

/// G between all points x and y: complex x × y. Coincident points give i Im G(0) = c.
MatXcd kernel_matrix(const RadialKernel& kernel, const Points2& x, const Points2& y);

}  // namespace floe::fmm::multipole
