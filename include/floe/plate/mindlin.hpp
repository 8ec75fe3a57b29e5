#pragma once

#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/types.hpp>
#include <floe/plate/plate_properties.hpp>

namespace floe::plate {

/// Unknowns of node n: rows 3n (w), 3n+1 (θx), 3n+2 (θy), with u = z θy, v = -z θx.
inline constexpr int kUnknownsPerNode = 3;

/// Stiffness and consistent mass of the free plate, 3N × 3N, symmetric, both triangles stored.
struct PlateMatrices {
  SparseMatrix stiffness;  ///< K [N/m, N, N m]
  SparseMatrix mass;       ///< M, rotary inertia included [kg, kg m, kg m²]
};

/// Assembles K and M of paper (3): bending with 3 × 3 Gauss points, shear with 2 × 2 (against
/// locking), mass with 3 × 3. The loss factor is not part of K: the modal equation takes it.
PlateMatrices assemble_plate(const mesh::Q8Mesh& mesh, const PlateProperties& properties);

}  // namespace floe::plate
