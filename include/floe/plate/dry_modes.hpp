#pragma once

#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/types.hpp>
#include <floe/plate/plate_regions.hpp>

namespace floe::plate {

/// What the computation of the modes took, summed over the pieces.
struct DryModeReport {
  double assembly_seconds = 0.0;
  double factor_seconds = 0.0;
  double iteration_seconds = 0.0;
  Index factor_entries = 0;  ///< of the largest piece, 8 bytes each
  Index solve_count = 0;     ///< columns solved with the factor
  double largest_residual = 0.0;  ///< of the modes, ‖c - (λ + s)(K + sM)⁻¹M c‖ over ‖c‖, norm of M
};

/// The lowest dry modes of a free plate, (K - ω_i² M) c_i = 0, paper (4).
/// First the rigid modes, three a piece in the order of the pieces: heave (w = 1), roll about x
/// (w = y - y_c, θx = 1) and pitch about y (w = -(x - x_c), θy = 1), about the piece's centroid,
/// unmixed, each scaled to cᵀMc = 1. Then the elastic modes of all pieces by rising frequency,
/// mass-normalised, each with its largest |w| positive.
struct DryModes {
  VecXd omega;       ///< ω_i [rad/s]; exactly 0 for the rigid modes
  MatXd shape;       ///< 3N × q; rows w [m], θx, θy [rad] of each node
  MatXd modal_mass;  ///< CᵀMC, q × q: the identity, but roll and pitch of a piece couple where ∫xy
                     ///< ≠ 0, and with heave where its mass per area differs
  int rigid_count = 0;  ///< 3 · number of pieces
  /// ∫ρt³/12 dS of each piece [kg m²], that is θᵀMθ of θx or θy = 1 alone; 0 where only modes are
  /// known.
  VecXd rotary_inertia;
  /// Largest relative error of ω_i, estimated (P.10) from the jumps of the section forces between
  /// inner elements and from (kh)⁴/480, k the wavenumber of bending waves and h the longest side.
  /// Over rectangles, rings and L-shapes, distorted too, with 30 modes: 0.5 to 4.5 times the true
  /// one where that is above 1e-3; 0.2 (re-entrant corner, fine mesh) to 13 times down to 3e-5.
  double estimated_frequency_error = 0.0;
  double orthonormality_error = 0.0;  ///< largest |CᵀMC - modal_mass|, recomputed piece by piece
  double rigid_force_error = 0.0;     ///< largest |Kc| over the largest |K||c| of the rigid modes
  DryModeReport report;
  Index count() const { return omega.size(); }
};

struct DryModeOptions {
  int count = 30;            ///< q, rigid modes included
  double tolerance = 1e-10;  ///< relative eigenvalue residual asked of the Lanczos iteration
  int max_restarts = 300;    ///< of the Lanczos iteration, for each 100 modes
};

/// Computes them by shift-invert Lanczos (Spectra) on a sparse Cholesky factorisation (CHOLMOD),
/// piece by piece; the rigid modes are made exactly. Throws InputError when count < 3 a piece or
/// more than half the unknowns; ConvergenceError (with how many converged) when modes are missing;
/// BudgetError when memory does not suffice for the factor.
/// NOTE: sets a threaded OpenBLAS to one thread, and leaves it so.
DryModes dry_modes(const mesh::Q8Mesh& mesh, const PlateRegions& regions,
                   const DryModeOptions& options = {});

/// Modes of a coarser plate mesh at the nodes of a finer fluid mesh of the same outline, by the Q8
/// functions of the plate's elements. Throws MeshError when a fluid node lies on no plate element.
DryModes interpolate_modes(const DryModes& modes, const mesh::Q8Mesh& plate_mesh,
                           const mesh::Q8Mesh& fluid_mesh);

}  // namespace floe::plate
