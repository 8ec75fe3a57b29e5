#include "fluid_march.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace floe {
namespace {

constexpr Index kCubic = 4;
constexpr double kFinest = 1.0 / 64.0;  // of the first step
constexpr double kCoarsest = 6.0;
constexpr double kEasy =
    1.0 / 10.0;  // of the tolerance: 1.5⁴ times more is safe, the next step may grow

double node_polynomial(std::span<const double> nodes, double x) {
  double product = 1.0;
  for (const double node : nodes) product *= x - node;
  return product;
}

double first_step(const FluidMarch::Options& options) {
  return std::min(options.first_step, (options.omega.back() - options.omega.front()) / 5.0);
}

}  // namespace

std::vector<double> lagrange_weights(std::span<const double> nodes, double x) {
  std::vector<double> weights(nodes.size(), 1.0);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if (i != j) weights[i] *= (x - nodes[j]) / (nodes[i] - nodes[j]);
  return weights;
}

FluidMarch::FluidMarch(const Options& options, Solve solve, Difference difference)
    : omega_(options.omega),
      step_(first_step(options)),
      least_step_(kFinest * step_),
      tolerance_(options.tolerance),
      solve_(std::move(solve)),
      difference_(std::move(difference)) {
  solve_at(0, 0);
  while (samples_.size() < 5) extend();
  refine();
}

FluidMarch::FluidMarch(const Options& options, const SeaMarch& earlier,
                       std::deque<FluidSample> samples, Solve solve, Difference difference)
    : omega_(options.omega),
      step_(earlier.step),
      least_step_(kFinest * first_step(options)),
      tolerance_(options.tolerance),
      solve_(std::move(solve)),
      difference_(std::move(difference)),
      samples_(std::move(samples)),
      numbers_(earlier.samples.begin(), earlier.samples.end()),
      interval_(earlier.interval),
      solved_(earlier.solved),
      largest_error_(earlier.largest_error) {}

SeaMarch FluidMarch::state() const {
  SeaMarch state;
  state.interval = interval_;
  state.step = step_;
  state.solved = solved_;
  state.largest_error = largest_error_;
  state.samples.assign(numbers_.begin(), numbers_.end());
  return state;
}

// One more sample, before the one that is at that place now, at the frequency of that number
void FluidMarch::solve_at(std::size_t place, Index number) {
  const auto at = static_cast<std::ptrdiff_t>(place);
  samples_.insert(samples_.begin() + at, solve_(solved_, omega_[static_cast<std::size_t>(number)]));
  numbers_.insert(numbers_.begin() + at, solved_);
  ++solved_;
}

// The nearest of the frequencies
Index FluidMarch::number_of(double omega) const {
  const auto above = std::lower_bound(omega_.begin(), omega_.end(), omega);
  const Index number = above - omega_.begin();
  if (above == omega_.begin()) return number;
  if (above == omega_.end()) return number - 1;
  return omega - *(above - 1) < *above - omega ? number - 1 : number;
}

// One more frequency at the high end, such that five can be had
void FluidMarch::extend() {
  const double last = samples_.back().omega, left = omega_.back() - last;
  const double step = left < 1.5 * step_ ? (left > step_ ? 0.5 * left : left) : step_;
  const Index others = std::max<Index>(0, 4 - static_cast<Index>(samples_.size()));
  const Index highest = static_cast<Index>(omega_.size()) - 1 - others;
  solve_at(samples_.size(), std::clamp(number_of(last + step), number_of(last) + 1, highest));
}

// First sample of the cubic for an interval: one on each side where there is one
Index FluidMarch::cubic_of(Index interval) const {
  return std::clamp<Index>(interval - 1, 0, static_cast<Index>(samples_.size()) - kCubic);
}

FluidSample FluidMarch::interpolate(double omega, Index first) const {
  double nodes[kCubic];
  for (Index i = 0; i < kCubic; ++i) nodes[i] = samples_[static_cast<std::size_t>(first + i)].omega;
  const std::vector<double> weights = lagrange_weights(nodes, omega);
  const FluidSample& origin = samples_[static_cast<std::size_t>(first)];
  FluidSample result{.omega = omega,
                     .pressure = weights[0] * origin.pressure,
                     .fluid_matrix = weights[0] * origin.fluid_matrix,
                     .solved = {}};
  for (Index i = 1; i < kCubic; ++i) {
    const FluidSample& sample = samples_[static_cast<std::size_t>(first + i)];
    result.pressure += weights[static_cast<std::size_t>(i)] * sample.pressure;
    result.fluid_matrix += weights[static_cast<std::size_t>(i)] * sample.fluid_matrix;
  }
  return result;
}

// (E.10): the cubic of the interval against the one that is shifted by a sample
double FluidMarch::estimate(Index interval) const {
  const Index first = cubic_of(interval);
  const Index other = first > 0 ? first - 1 : first + 1;
  const auto at = [&](Index i) { return samples_[static_cast<std::size_t>(i)].omega; };
  const double middle = 0.5 * (at(interval) + at(interval + 1));
  double nodes[kCubic], shifted[kCubic];
  for (Index i = 0; i < kCubic; ++i) {
    nodes[i] = at(first + i);
    shifted[i] = at(other + i);
  }
  const double own = node_polynomial(nodes, middle), their = node_polynomial(shifted, middle);
  return std::abs(own / (own - their)) *
         difference_(interpolate(middle, first), interpolate(middle, other));
}

// Halves the current interval until its estimate is small enough
void FluidMarch::refine() {
  for (;;) {
    while (static_cast<Index>(samples_.size()) < interval_ + 4 &&
           samples_.back().omega < omega_.back())
      extend();
    const auto i = static_cast<std::size_t>(interval_);
    const double width = samples_[i + 1].omega - samples_[i].omega;
    const Index below = number_of(samples_[i].omega), above = number_of(samples_[i + 1].omega);
    const double error = above - below > 1 ? estimate(interval_) : 0.0;
    if (error <= tolerance_ || 0.5 * width < least_step_) {
      largest_error_ = std::max(largest_error_, error);
      if (error < kEasy * tolerance_)
        step_ = std::min(1.5 * step_, kCoarsest * least_step_ / kFinest);
      return;
    }
    step_ = std::max(least_step_, 0.5 * width);
    solve_at(i + 1, std::clamp(number_of(samples_[i].omega + 0.5 * width), below + 1, above - 1));
  }
}

FluidSample FluidMarch::at(double omega) {
  while (omega > samples_[static_cast<std::size_t>(interval_) + 1].omega &&
         !(samples_.back().omega >= omega_.back() &&
           interval_ + 2 == static_cast<Index>(samples_.size()))) {
    ++interval_;
    while (interval_ > 3) {
      samples_.pop_front();
      numbers_.pop_front();
      --interval_;
    }
    refine();
  }
  return interpolate(omega, cubic_of(interval_));
}

}  // namespace floe
