#pragma once

#include <floe/mesh/q8_mesh.hpp>
#include <floe/plate/plate_regions.hpp>

namespace floe::plate {

/// Estimates of the relative errors of ω_i from the mesh (P.10), 0 for rigid modes; meant for the
/// largest of them. See DryModes::estimated_frequency_error.
VecXd estimate_frequency_errors(const mesh::Q8Mesh& mesh, const PlateRegions& regions,
                                const Eigen::Ref<const VecXd>& omega,
                                const Eigen::Ref<const MatXd>& shape);

}  // namespace floe::plate
