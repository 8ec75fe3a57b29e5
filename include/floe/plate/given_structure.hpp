#pragma once

#include <floe/plate/dry_modes.hpp>
#include <floe/plate/mindlin.hpp>

/// A plate that another program has modelled: its matrices or its modes, in the place of those of
/// mindlin.hpp and in the same order, rows 3n (w), 3n + 1 (θx), 3n + 2 (θy) of node n of the mesh.
namespace floe::plate {

/// Modes as they were given, one a column.
struct GivenModes {
  VecXd omega;        ///< [rad/s], any order
  MatXd shape;        ///< 3N × q, mass-normalised
  SparseMatrix mass;  ///< M; empty: not given, orthonormality is taken on trust
};

/// Throws MeshError unless K and M are 3N × 3N and symmetric to 1e-9 of their largest entry, the
/// mass of every deflection is positive, no entry couples two pieces of the mesh, and K does not
/// resist the three rigid motions of any piece, ‖K r‖ ≤ 1e-6 ‖|K| |r|‖ in the largest entry.
void check_matrices(const mesh::Q8Mesh& mesh, const PlateMatrices& given);

/// The modes of K and M as those of dry_modes. Throws MeshError as check_matrices, and when K + sM
/// is not positive definite or a piece has more than three motions without stiffness (ω² below 1e-8
/// of that of a plate bent to constant curvature).
DryModes dry_modes(const mesh::Q8Mesh& mesh, const PlateMatrices& given,
                   const DryModeOptions& options);

/// Throws MeshError unless there are 3N rows and a frequency for each column, at least three
/// columns a piece, and, with M, CᵀMC = I to 1e-6.
void check_modes(const mesh::Q8Mesh& mesh, const GivenModes& given);

/// The first `count` of the given modes in the order of dry_modes. Those with ω below 1e-3 of the
/// next must be three a piece and rigid motions to 1e-6 of their size; heave, roll and pitch take
/// their place, scaled by M, or else by what the given ones tell of it. Throws MeshError as
/// check_modes, or when they are not.
DryModes dry_modes(const mesh::Q8Mesh& mesh, const GivenModes& given, int count);

}  // namespace floe::plate
