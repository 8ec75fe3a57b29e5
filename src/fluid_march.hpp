#pragma once

#include <floe/sea_results.hpp>

#include <deque>
#include <functional>
#include <span>
#include <vector>

/// The fluid between the frequencies at which it was solved.
namespace floe {

/// Lagrange's weights of `nodes` at x.
std::vector<double> lagrange_weights(std::span<const double> nodes, double x);

/// Goes from the low to the high end of a band, solves as few frequencies as an error estimate
/// allows and keeps at most eight of them.
class FluidMarch {
 public:
  /// Solves the sample of this number, from 0.
  using Solve = std::function<FluidSample(int number, double omega)>;
  /// How far apart the responses to two candidates for the fluid at one frequency are, relative to
  /// what matters.
  using Difference = std::function<double(const FluidSample&, const FluidSample&)>;

  struct Options {
    /// Where the fluid will be told, rising, five or more [rad/s]: only these are solved, and
    /// between two neighbours there is nothing to tell. A view.
    std::span<const double> omega;
    double first_step = 0.0;  ///< [rad/s]
    double tolerance = 1e-3;  ///< of the difference, estimated
  };

  FluidMarch(const Options& options, Solve solve, Difference difference);
  /// Goes on where an earlier march was, with the samples that it names.
  FluidMarch(const Options& options, const SeaMarch& earlier, std::deque<FluidSample> samples,
             Solve solve, Difference difference);

  /// Moves on until the fluid at `omega` can be told; frequencies must not fall.
  FluidSample at(double omega);

  /// All but `next` and `largest_response`.
  SeaMarch state() const;
  int solved() const { return solved_; }
  double largest_error() const { return largest_error_; }  ///< (E.10) over the intervals used

 private:
  void solve_at(std::size_t place, Index number);
  void extend();
  Index number_of(double omega) const;
  void refine();
  double estimate(Index interval) const;
  FluidSample interpolate(double omega, Index first) const;
  Index cubic_of(Index interval) const;

  std::span<const double> omega_;
  double step_, least_step_, tolerance_;
  Solve solve_;
  Difference difference_;
  std::deque<FluidSample> samples_;
  std::deque<int> numbers_;  // of the samples
  Index interval_ = 0;       // its lower end, in samples_
  int solved_ = 0;
  double largest_error_ = 0.0;
};

}  // namespace floe
