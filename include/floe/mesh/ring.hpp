#pragma once

#include <floe/mesh/q8_mesh.hpp>

namespace floe::mesh {

struct RingOptions {
  double inner_radius = 0.0;  ///< [m]
  double outer_radius = 0.0;  ///< [m]
  double element_size = 0.0;  ///< no element edge is longer [m]
};

/// Mesh of the ring about the origin: layers of curved elements, all nodes of arcs on their circle,
/// the layers thinner towards the middle as their arcs get shorter, so that elements are nearly
/// square (one layer if the ring is narrower than an element). Throws InputError on a size that is
/// not positive, on an inner radius that is not less than the outer one, and on more than 1e8
/// elements.
Q8Mesh make_ring(const RingOptions& options);

}  // namespace floe::mesh
