#pragma once

#include "bem/source_rule.hpp"

#include <floe/mesh/q8_mesh.hpp>

namespace floe::bem {

struct SourceChoice {
  SourcePoints points;
  double near_radius;  ///< of elements, from their centre, in longest edges
};

/// The cheapest source points and near radius that hold a relative tolerance of 𝒢p for any p up to
/// a wavenumber [rad/m]. Throws InputError where waves are too short for the elements.
SourceChoice choose_sources(const mesh::Q8Mesh& mesh, double tolerance, double max_wavenumber);

}  // namespace floe::bem
