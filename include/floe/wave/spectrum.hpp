#pragma once

#include <vector>

namespace floe::wave {

/// One-sided variance spectrum of the elevation at a point, S(ω) [m² s/rad], ∫₀^∞ S dω = m0.
class Spectrum {
 public:
  /// Bretschneider–Mitsuyasu (E.1), paper (27): H1/3 [m] and T1/3 [s]. 4√m0 = 0.999 H1/3.
  static Spectrum bretschneider(double significant_height, double significant_period);
  /// Pierson–Moskowitz (E.2) of height Hs = 4√m0 [m] and peak period Tp [s].
  static Spectrum pierson_moskowitz(double significant_height, double peak_period);
  /// JONSWAP (E.3), rescaled so that 4√m0 = Hs; peak enhancement γ ≥ 1 (1: Pierson–Moskowitz).
  static Spectrum jonswap(double significant_height, double peak_period, double gamma);
  /// Straight lines between given values, zero outside; ω ascending, two or more [rad/s].
  static Spectrum tabulated(std::vector<double> omega, std::vector<double> density);

  /// S(ω), 0 for ω ≤ 0. Throws InputError from the makers above when an argument is not positive
  /// and finite (γ < 1, a table not ascending or negative).
  double operator()(double omega) const;

  /// ∫ S dω from `from` to `to` (may be infinite) [m²], relative error 1e-8 of m0.
  double variance(double from, double to) const;
  /// ∫ ω^order S dω over all frequencies, order -1 to 2 [m² (rad/s)^order]. Tables that begin at 0
  /// have no order -1.
  double moment(int order) const;
  double m0() const { return m0_; }  ///< over all frequencies [m²]

 private:
  Spectrum() = default;
  double shape(double omega) const;
  double integral(int order, double from, double to) const;
  double table_integral(int order, double from, double to) const;

  double peak_ = 0.0;   // [rad/s]
  double tail_ = 0.0;   // factor of ω⁻⁵ [m² s⁻⁴]
  double decay_ = 0.0;  // exp(-decay (peak/ω)⁴)
  double gamma_ = 1.0;
  std::vector<double> omega_, density_;  // of a table
  double m0_ = 0.0;
};

}  // namespace floe::wave
