#pragma once

#include <floe/wave/spectrum.hpp>
#include <floe/wave/spreading.hpp>

#include <string>
#include <vector>

namespace floe::wave {

/// A stationary sea S(ω) D(θ - θ̄), for one or more mean headings θ̄.
struct SeaState {
  std::string name;
  std::string description;  ///< spectrum and spreading in words, for people
  Spectrum spectrum;
  Spreading spreading;
  std::vector<double> mean_heading_deg;  ///< where the waves travel to, from +x towards +y [deg]
  bool allow_truncation = false;         ///< accept more than 5 % of m0 outside the computed band
};

}  // namespace floe::wave
