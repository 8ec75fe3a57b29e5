#pragma once

#include <floe/mesh/q8_mesh.hpp>

namespace floe::mesh {

struct DiscOptions {
  double radius = 0.0;        ///< [m]
  double element_size = 0.0;  ///< no element edge is longer [m]
};

/// Mesh of the disc about the origin: a core of n × n elements with bulging sides, and 4n sectors
/// of rings around it, whose outermost edges are curved with all their nodes on the circle. At the
/// four corners of the core three elements meet at 120°. Throws InputError on a size that is not
/// positive, and on more than 1e8 elements.
Q8Mesh make_disc(const DiscOptions& options);

}  // namespace floe::mesh
