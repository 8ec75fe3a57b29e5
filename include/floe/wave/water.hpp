#pragma once

#include <limits>

namespace floe::wave {

/// Calm water under the plate. SI units.
struct Water {
  double depth = std::numeric_limits<double>::infinity();  ///< h [m], may be infinite
  double density = 1025.0;                                 ///< ρ [kg/m³]
  double gravity = 9.81;                                   ///< g [m/s²]
};

}  // namespace floe::wave
