#include <floe/numeric/error.hpp>
#include <floe/response/long_term.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace floe::response {

LongTermDistribution::LongTermDistribution(const std::vector<ShortTermResponse>& states) {
  double largest = 0.0;
  for (const ShortTermResponse& state : states) largest = std::max(largest, state.m0);
  for (const ShortTermResponse& state : states) {
    for (const double value : {state.probability, state.m0, state.m2})
      FLOE_VALIDATE(std::isfinite(value) && value >= 0.0,
                    "invalid sea state: probability " << state.probability << ", m0 = " << state.m0
                                                      << ", m2 = " << state.m2
                                                      << " (must be at least 0)");
    // NOTE: amplitudes of 1e-15 of the largest are rounding, not motion
    const double crossings = state.m0 > 1e-30 * largest
                                 ? std::sqrt(state.m2 / state.m0) / (2.0 * std::numbers::pi)
                                 : 0.0;
    states_.push_back({state.probability * crossings, state.m0});
    rate_ += states_.back().rate;
  }
}

// ln of the exceedance of √square, and its slope over the square; the largest term taken out, so
// that it may be as rare as it will
double LongTermDistribution::log_exceedance(double square, double* slope) const {
  double largest = -std::numeric_limits<double>::infinity();
  for (const State& state : states_)
    if (state.rate > 0.0) largest = std::max(largest, -0.5 * square / state.m0);
  double sum = 0.0, derivative = 0.0;
  for (const State& state : states_) {
    if (!(state.rate > 0.0)) continue;
    const double term = state.rate * std::exp(-0.5 * square / state.m0 - largest);
    sum += term;
    derivative -= 0.5 / state.m0 * term;
  }
  if (slope) *slope = derivative / sum;
  return std::log(sum / rate_) + largest;
}

double LongTermDistribution::exceedance(double level) const {
  if (level <= 0.0) return 1.0;
  return moves() ? std::exp(log_exceedance(level * level, nullptr)) : 0.0;
}

double LongTermDistribution::level(double exceedance) const {
  FLOE_VALIDATE(exceedance > 0.0 && exceedance <= 1.0,
                "invalid exceedance = " << exceedance << " (must be above 0 and at most 1)");
  FLOE_VALIDATE(moves(), "a response that never moves has no level");
  // Each state alone gives less than all of them: below the root, by little
  const double wanted = std::log(exceedance);
  double square = 0.0;
  for (const State& state : states_)
    if (state.rate > 0.0)
      square = std::max(square, 2.0 * state.m0 * (std::log(state.rate / rate_) - wanted));

  // ln of a sum of falling exponentials is convex: from there Newton's steps never pass the root
  for (int i = 0; i < 100; ++i) {
    double slope = 0.0;
    const double step = (wanted - log_exceedance(square, &slope)) / slope;
    square += step;
    if (std::abs(step) <= 1e-13 * square) break;
  }
  return std::sqrt(std::max(square, 0.0));
}

double LongTermDistribution::return_value(double period) const {
  FLOE_VALIDATE(std::isfinite(period) && period > 0.0,
                "invalid return period = " << period << " s (must be positive)");
  const double peaks = rate_ * period;
  return peaks > 1.0 ? level(1.0 / peaks) : 0.0;
}

std::vector<double> LongTermDistribution::contributions(double level) const {
  std::vector<double> shares(states_.size(), 0.0);
  if (!moves()) return shares;
  const double all = log_exceedance(level * level, nullptr);
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (states_[i].rate > 0.0)
      shares[i] = states_[i].rate / rate_ * std::exp(-0.5 * level * level / states_[i].m0 - all);
  return shares;
}

}  // namespace floe::response
