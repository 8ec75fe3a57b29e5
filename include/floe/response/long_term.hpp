#pragma once

#include <vector>

namespace floe::response {

/// A response in one of the sea states of many years.
struct ShortTermResponse {
  double probability = 0.0;  ///< of the sea state; the calm is what is missing from 1
  double m0 = 0.0;           ///< [unit²]
  double m2 = 0.0;           ///< [unit²/s²]
};

/// Amplitudes of a response over many years: Rayleigh's distribution in each sea state, which
/// counts by how often it occurs and how many peaks it has (E.21), (E.22).
class LongTermDistribution {
 public:
  /// States without motion have no peaks. Throws InputError when a probability or a moment is
  /// negative or not finite.
  explicit LongTermDistribution(const std::vector<ShortTermResponse>& states);

  /// Whether anything moves; without it there are no levels to be asked for.
  bool moves() const { return rate_ > 0.0; }
  /// Mean number of peaks, zero up-crossings, in a second.
  double peak_rate() const { return rate_; }
  /// Probability that a peak exceeds `level` ≥ 0.
  double exceedance(double level) const;
  /// The level that a peak exceeds with that probability, above 0 and at most 1; relative error
  /// 1e-12. Throws InputError for others, or when nothing moves.
  double level(double exceedance) const;
  /// The level that is exceeded once in `period` [s] on average; 0 when there is less than one peak
  /// in it.
  double return_value(double period) const;
  /// Which share of the peaks beyond `level` each state has, in the order given.
  std::vector<double> contributions(double level) const;

 private:
  struct State {
    double rate, m0;
  };
  double log_exceedance(double square, double* slope) const;

  std::vector<State> states_;
  double rate_ = 0.0;
};

}  // namespace floe::response
