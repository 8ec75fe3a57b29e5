#pragma once

#include "plate/shifted_factor.hpp"
#include "plate/sparse_products.hpp"

namespace floe::plate {

/// Eigenpairs K x = λ M x in the M-orthogonal complement of given vectors.
struct Eigenpairs {
  VecXd value;   ///< rising
  MatXd vector;  ///< one a column, M-orthonormal to the tolerance
  Index solve_count = 0;
};

struct LanczosOptions {
  Index count = 1;           ///< eigenpairs wanted: the lowest ones
  double tolerance = 1e-10;  ///< residual of 1/(λ + s), relative
  unsigned seed = 1;         ///< of the start vector
  int max_restarts = 300;
};

/// Implicitly restarted Lanczos (Spectra) for (K + sM)⁻¹ M, s = `shift`, in the complement of
/// `deflated` (M-orthonormal). Fewer pairs than wanted come back when not all converged.
/// NOTE: a Krylov space holds one vector of a multiple eigenvalue; others enter by rounding, sooner
/// or later. Whoever needs them all deflates what was found and looks again.
Eigenpairs lowest_eigenpairs(const NodeMass& node_mass, const ShiftedFactor& factor, double shift,
                             const Eigen::Ref<const MatXd>& deflated,
                             const LanczosOptions& options);

}  // namespace floe::plate
