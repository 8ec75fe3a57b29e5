#pragma once

#include <floe/numeric/types.hpp>

#include <deque>
#include <functional>
#include <span>
#include <vector>

/// The fluid between the frequencies at which it was solved.
namespace floe {

/// Radiation pressures and fluid matrix of one frequency.
struct FluidSample {
  double omega = 0.0;   ///< [rad/s]
  MatXcd pressure;      ///< p_i, N × q
  MatXcd fluid_matrix;  ///< P, q × q
};

/// Lagrange's weights of `nodes` at x.
std::vector<double> lagrange_weights(std::span<const double> nodes, double x);

/// Goes from the low to the high end of a band, solves as few frequencies as an error estimate
/// allows and keeps at most eight of them.
class FluidMarch {
 public:
  using Solve = std::function<FluidSample(double omega)>;
  /// How far apart the responses to two candidates for the fluid at one frequency are, relative to
  /// what matters.
  using Difference = std::function<double(const FluidSample&, const FluidSample&)>;

  FluidMarch(double from, double to, double first_step, double tolerance, Solve solve,
             Difference difference);

  /// Moves on until the fluid at `omega` can be told; frequencies must not fall.
  FluidSample at(double omega);

  int solved() const { return solved_; }
  double largest_error() const { return largest_error_; }  ///< (E.10) over the intervals used

 private:
  void extend();
  void refine();
  double estimate(Index interval) const;
  FluidSample interpolate(double omega, Index first) const;
  Index cubic_of(Index interval) const;

  double to_, step_, least_step_, tolerance_;
  Solve solve_;
  Difference difference_;
  std::deque<FluidSample> samples_;
  Index interval_ = 0;  // its lower end, in samples_
  int solved_ = 0;
  double largest_error_ = 0.0;
};

}  // namespace floe
