#pragma once

#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/types.hpp>
#include <floe/plate/plate_regions.hpp>

namespace floe::plate {

/// Unknowns of node n: rows 3n (w), 3n+1 (θx), 3n+2 (θy), with u = z θy, v = -z θx.
inline constexpr int kUnknownsPerNode = 3;

/// Stiffness and consistent mass of the free plate, 3N × 3N, symmetric, both triangles stored.
struct PlateMatrices {
  SparseMatrix stiffness;  ///< K [N/m, N, N m]
  SparseMatrix mass;       ///< M, rotary inertia included [kg, kg m, kg m²]
};

/// Assembles K and M of paper (3), here (P.5): bending with 3 × 3 Gauss points; shear with 2 × 2
/// (against locking) of strains tied along the sides and the middle lines (P.6), on parallelograms
/// nearly the plain 2 × 2 rule; mass with 3 × 3. The loss factor is not part of K: the modal
/// equation takes it. Valid for thickness over element side from 1e-5 to any.
/// NOTE: plain 2 × 2 shear locks where opposite sides are not parallel. First 30 frequencies of a
/// 300 m × 60 m plate on 12 m elements, sides bent and nodes moved by up to 2 m, largest error at
/// 2 m and 0.1 m thickness: 3.3 % and 87 % plain, 0.8 % and 0.9 % tied.
/// The same bits for any number of threads. Throws InputError on properties that no plate has.
PlateMatrices assemble_plate(const mesh::Q8Mesh& mesh, const PlateRegions& regions);

}  // namespace floe::plate
