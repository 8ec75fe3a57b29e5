#pragma once

#include "plate/lanczos.hpp"

#include <floe/plate/dry_modes.hpp>

namespace floe::plate {

/// What the search for elastic modes needs to know of a plate; all views.
struct ElasticProblem {
  const PlateMatrices& plate;
  const NodeMass& mass;
  const ShiftedFactor& factor;
  double shift;              ///< s > 0 of K + sM [rad²/s²]
  const MatXd& rigid_basis;  ///< M-orthonormal
};

/// The lowest `options.count` elastic modes, multiple ones with all their copies. Throws
/// ConvergenceError with how many converged.
Eigenpairs elastic_modes(const ElasticProblem& problem, const DryModeOptions& options);

/// The same by a dense solution: for small plates, and the slow twin of the above.
Eigenpairs dense_elastic_modes(const PlateMatrices& plate, double shift, const MatXd& rigid_basis,
                               Index count);

/// Residuals of the pairs, ‖c - (λ + s)(K + sM)⁻¹M c‖ over ‖c‖ in the norm of K + sM: bounds of the
/// relative error of λ + s. In the norm of M rounding that lies along the lowest modes would count
/// by the ratio of the eigenvalues, in this one by its root.
VecXd inverse_residuals(const ElasticProblem& problem, const Eigenpairs& pairs);

}  // namespace floe::plate
