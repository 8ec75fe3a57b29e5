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

}  // namespace

std::vector<double> lagrange_weights(std::span<const double> nodes, double x) {
  std::vector<double> weights(nodes.size(), 1.0);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if (i != j) weights[i] *= (x - nodes[j]) / (nodes[i] - nodes[j]);
  return weights;
}

FluidMarch::FluidMarch(double from, double to, double first_step, double tolerance, Solve solve,
                       Difference difference)
    : to_(to),
      step_(std::min(first_step, (to - from) / 5.0)),
      least_step_(kFinest * step_),
      tolerance_(tolerance),
      solve_(std::move(solve)),
      difference_(std::move(difference)) {
  samples_.push_back(solve_(from));
  solved_ = 1;
  while (samples_.size() < 5) extend();
  refine();
}

// One more frequency at the high end
void FluidMarch::extend() {
  const double last = samples_.back().omega;
  const double left = to_ - last;
  const double step = left < 1.5 * step_ ? (left > step_ ? 0.5 * left : left) : step_;
  samples_.push_back(solve_(left - step < 1e-9 * to_ ? to_ : last + step));
  ++solved_;
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
  FluidSample result{omega, weights[0] * origin.pressure, weights[0] * origin.fluid_matrix};
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
    while (static_cast<Index>(samples_.size()) < interval_ + 4 && samples_.back().omega < to_)
      extend();
    const auto i = static_cast<std::size_t>(interval_);
    const double width = samples_[i + 1].omega - samples_[i].omega;
    const double error = estimate(interval_);
    if (error <= tolerance_ || 0.5 * width < least_step_) {
      largest_error_ = std::max(largest_error_, error);
      if (error < kEasy * tolerance_)
        step_ = std::min(1.5 * step_, kCoarsest * least_step_ / kFinest);
      return;
    }
    step_ = std::max(least_step_, 0.5 * width);
    samples_.insert(samples_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                    solve_(samples_[i].omega + 0.5 * width));
    ++solved_;
  }
}

FluidSample FluidMarch::at(double omega) {
  while (omega > samples_[static_cast<std::size_t>(interval_) + 1].omega &&
         !(samples_.back().omega >= to_ && interval_ + 2 == static_cast<Index>(samples_.size()))) {
    ++interval_;
    while (interval_ > 3) {
      samples_.pop_front();
      --interval_;
    }
    refine();
  }
  return interpolate(omega, cubic_of(interval_));
}

}  // namespace floe
