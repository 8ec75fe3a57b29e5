#pragma once

#include <floe/wave/directional_spectrum.hpp>
#include <floe/wave/spectrum.hpp>
#include <floe/wave/spreading.hpp>
#include <floe/wave/zones.hpp>

#include <optional>
#include <string>
#include <vector>

namespace floe::wave {

/// Waves of one origin, S(ω) D(θ - θ̄): a wind sea or a swell.
struct Partition {
  Spectrum spectrum;
  Spreading spreading;
  double turn_deg = 0.0;  ///< of its mean heading from the sea's [deg]
  /// S(ω, θ) where it was measured, in headings of the structure; then `spectrum` is its S(ω) and
  /// `spreading` has no meaning.
  std::optional<DirectionalSpectrum> measured = {};
};

/// A stationary sea, the sum of its partitions, for one or more mean headings θ̄. With zones it is
/// not the same everywhere: each partition holds in one zone, all have one spreading and no turn,
/// and what follows tells their mean.
struct SeaState {
  std::string name;
  std::string description;               ///< spectrum and spreading in words, for people
  std::vector<Partition> partitions;     ///< one or more
  std::vector<double> mean_heading_deg;  ///< where the waves travel to, from +x towards +y [deg]
  double duration = 10'800.0;            ///< of the storm, for its largest value [s]
  bool allow_truncation = false;         ///< accept more than 5 % of m0 outside the computed band
  std::optional<Zones> zones = {};       ///< one a partition

  double density(double omega) const;             ///< S(ω) over all directions [m² s/rad]
  double variance(double from, double to) const;  ///< ∫ S dω [m²]
  double m0() const;                              ///< over all frequencies [m²]
};

}  // namespace floe::wave
