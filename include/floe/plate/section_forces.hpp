#pragma once

#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/types.hpp>
#include <floe/plate/plate_regions.hpp>

#include <span>

namespace floe::plate {

/// Rows of node n in the result of section_forces, 5n + these.
enum SectionForce : int {
  kBendingMomentX = 0,  ///< ∫ z σxx dz [N m/m]
  kBendingMomentY = 1,  ///< ∫ z σyy dz [N m/m]
  kTwistingMoment = 2,  ///< ∫ z σxy dz [N m/m]
  kShearForceX = 3,     ///< shear_correction · G · thickness · (∂w/∂x + θy) [N/m]
  kShearForceY = 4,     ///< shear_correction · G · thickness · (∂w/∂y - θx) [N/m]
};
inline constexpr int kSectionForces = 5;

/// Section moments and shear forces at the nodes, (5N × columns), from displacements (3N ×
/// columns): evaluated at the 2 × 2 Gauss points, where they are most accurate, extrapolated
/// bilinearly to the nodes and averaged over the elements that meet there, on the line between two
/// regions over those of both. Linear in the displacements.
MatXd section_forces(const mesh::Q8Mesh& mesh, const PlateRegions& regions,
                     const Eigen::Ref<const MatXd>& displacement);

inline constexpr int kAllRegions = -1;

/// The same as a matrix, for some nodes and, where moments jump between regions, from the elements
/// of one region only (rows of nodes that touch none are zero): rows 5k + SectionForce of nodes[k],
/// columns as the unknowns (3N). Applied once to the mode shapes it serves any number of modal
/// amplitudes.
SparseMatrix section_force_operator(const mesh::Q8Mesh& mesh, const PlateRegions& regions,
                                    std::span<const Index> nodes, int region = kAllRegions);

/// Slopes of the deflection.
enum Slope : int {
  kSlopeX = 0,  ///< ∂w/∂x [rad]
  kSlopeY = 1,  ///< ∂w/∂y [rad]
};

/// A slope at the nodes from the deflections there, N × N: the gradient of each element at its
/// nodes, averaged over the elements that meet.
SparseMatrix slope_operator(const mesh::Q8Mesh& mesh, Slope slope);

}  // namespace floe::plate
