#pragma once

#include <floe/numeric/types.hpp>

#include <limits>
#include <vector>

namespace floe::wave {

/// An upright rectangle of the plane; what is not given reaches without end.
struct ZoneBounds {
  double x_from = -std::numeric_limits<double>::infinity();  ///< [m]
  double x_to = std::numeric_limits<double>::infinity();
  double y_from = -std::numeric_limits<double>::infinity();
  double y_to = std::numeric_limits<double>::infinity();
};

/// Where the spectra of a sea that changes over the plate hold, and what they have to do with each
/// other.
struct Zones {
  std::vector<ZoneBounds> bounds;
  double transition = 0.0;  ///< width over which one zone passes into its neighbour [m]
  MatXd coherence;          ///< Γ, zones × zones, symmetric, 1 on the diagonal, 0 … 1 elsewhere
};

/// Γ = (1 - c) I + c 1 1ᵀ of `count` zones: c between any two of them.
MatXd uniform_coherence(Index count, double c);

/// L with Γ = L Lᵀ, zones × terms: one pseudo-excitation a column (E.24). Eigenvalues below 1e-12
/// of the largest are left out. Throws InputError when Γ is not symmetric with 1 on the diagonal
/// and 0 … 1 elsewhere, or has a negative eigenvalue.
MatXd coherence_factor(const MatXd& coherence);

/// g_z at points (2 × N), N × zones (E.23): the amplitude of a wave of zone z there. Smooth,
/// 1 inside a zone, 0 outside; gᵀ Γ g = 1 everywhere, so that zones with one spectrum have it
/// everywhere. Throws InputError naming a point that lies in no zone.
MatXd zone_amplitudes(const Zones& zones, const Points2& points);

}  // namespace floe::wave
