#pragma once

#include <floe/numeric/types.hpp>
#include <floe/wave/spectrum.hpp>
#include <floe/wave/spreading.hpp>

#include <string>
#include <vector>

namespace floe::wave {

/// The period that a scatter diagram is sorted by.
enum class PeriodType {
  kZeroCrossing,  ///< Tz = 2π √(m0/m2)
  kPeak,          ///< Tp = 2π/ωp
  kEnergy         ///< Te = 2π m₋₁/m0
};

/// How often which sea states occur: p(Hs, T) by classes, each told by the height and the period in
/// its middle.
struct ScatterDiagram {
  std::vector<double> height;  ///< Hs = 4√m0, ascending [m]
  std::vector<double> period;  ///< ascending [s]
  PeriodType period_type = PeriodType::kZeroCrossing;
  MatXd probability;  ///< heights × periods, adding up to 1
};

/// A scatter diagram of counts or probabilities, at least 0 (heights × periods), which are divided
/// by their sum. Throws InputError when heights or periods do not ascend from above 0, a count is
/// negative or not finite, or all are 0.
ScatterDiagram scatter_diagram(std::vector<double> height, std::vector<double> period,
                               PeriodType type, const MatXd& counts);

/// Tp [s] of the JONSWAP spectrum (γ = 1: Pierson–Moskowitz, Bretschneider) that has the period T
/// of that type: the ratio depends on γ alone (E.20).
double peak_period(PeriodType type, double period, double gamma);

/// The waves of many years at a place: a scatter diagram, and what its classes leave open.
struct WaveClimate {
  std::string name;
  std::string description;  ///< spectrum and spreading in words, for people
  ScatterDiagram scatter;
  double gamma = 1.0;  ///< of the JONSWAP spectra; 1 is Pierson–Moskowitz and Bretschneider
  Spreading spreading = Spreading::none();
  std::vector<double> mean_heading_deg;     ///< where the waves travel to [deg]
  std::vector<double> heading_probability;  ///< one a heading, adding up to 1, in every class
  std::vector<double> return_period_years;
  bool allow_truncation = false;  ///< accept more than 5 % of m0 outside the computed band

  /// Spectrum of 1 m of significant height with a period of the diagram.
  Spectrum spectrum(std::size_t period) const;
  double peak_period(std::size_t period) const;  ///< Tp of that period [s]
  /// Energy of all classes with a period, ∑ p Hs²/16 [m²].
  double energy(std::size_t period) const;
};

}  // namespace floe::wave
