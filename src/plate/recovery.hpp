#pragma once

#include "plate/element.hpp"

#include <floe/plate/section_forces.hpp>

/// Section forces and slopes inside an element, from its unknowns.
namespace floe::plate {

/// Rows 5g + SectionForce at the 2 × 2 Gauss points g, in the order of the corners.
using GaussForceMatrix = Eigen::Matrix<double, 4 * kSectionForces, kElementUnknowns>;
GaussForceMatrix gauss_force_matrix(const ElementNodes& nodes, const PlateProperties& properties);

/// Weights of the four Gauss points for the bilinear function through their values, at (ξ, η).
Eigen::Vector4d extrapolation_weights(double xi, double eta);

/// Rows 5a + SectionForce at the eight nodes, extrapolated from the Gauss points.
using NodalForceMatrix = Eigen::Matrix<double, 8 * kSectionForces, kElementUnknowns>;
NodalForceMatrix nodal_force_matrix(const ElementNodes& nodes, const PlateProperties& properties);

/// Rows 2a + Slope at the eight nodes, from the eight deflections.
using NodalSlopeMatrix = Eigen::Matrix<double, 16, 8>;
NodalSlopeMatrix nodal_slope_matrix(const ElementNodes& nodes);

}  // namespace floe::plate
