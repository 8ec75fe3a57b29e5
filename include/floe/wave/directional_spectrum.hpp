#pragma once

#include <floe/numeric/types.hpp>
#include <floe/wave/spectrum.hpp>

#include <vector>

namespace floe::wave {

/// A measured sea: one-sided S(ω, θ) [m² s/rad²] as a table, straight lines in between, zero beyond
/// its frequencies, closed around the circle.
class DirectionalSpectrum {
 public:
  /// `omega` ascending, two or more [rad/s]; `heading` where the waves travel to, ascending within
  /// a turn, three or more [rad]; density is omega × heading. Throws InputError otherwise, when a
  /// value is negative or not finite, or when all are 0.
  DirectionalSpectrum(std::vector<double> omega, std::vector<double> heading, MatXd density);

  const std::vector<double>& heading() const { return heading_; }
  /// S(ω, θ) at the headings of the table.
  VecXd density(double omega) const;
  /// S(ω) = ∫ S(ω, θ) dθ, by the table's own straight lines.
  Spectrum over_directions() const;
  /// Direction of ∫∫ S e^{iθ} dθ dω [rad].
  double mean_heading() const;

 private:
  VecXd widths() const;

  std::vector<double> omega_, heading_;
  MatXd density_;
};

}  // namespace floe::wave
