#pragma once

namespace floe::response {

/// What a narrow-banded Gaussian response of zero mean and its spectral moments m0, m2 mean for
/// design: amplitudes follow Rayleigh's distribution. All for single amplitudes.
struct DesignValues {
  double standard_deviation = 0.0;    ///< √m0
  double zero_crossing_period = 0.0;  ///< 2π √(m0/m2) [s]; infinite where m2 = 0
  double significant = 0.0;           ///< mean of the highest third of the amplitudes, 2√m0
  double most_probable_maximum = 0.0;  ///< √(2 m0 ln n), n = duration / period               (E.11)
};

/// For a storm of `duration` [s], which must be positive; fewer than one crossing counts as one.
/// Throws InputError when a moment is negative or not finite.
DesignValues design_values(double m0, double m2, double duration);

/// Probability that an amplitude exceeds `level`: exp(-level²/2m0); 0 where m0 = 0.
double exceedance(double level, double m0);

}  // namespace floe::response
