#pragma once

#include <floe/numeric/types.hpp>
#include <floe/wave/spreading.hpp>

#include <array>
#include <vector>

namespace floe::response {

/// Headings of a short-crested sea and how much of its energy each stands for.
struct DirectionGrid {
  std::vector<double> heading;  ///< where the waves travel to, ascending from the mean - ± [rad]
  std::vector<double> weight;   ///< D(θ - θ̄) Δθ, adding up to 1 within 1e-6
};

/// Equidistant headings around `mean` [rad], at least `least_count` on the full circle, as many as
/// make ∑ D Δθ = 1 to 1e-6; headings without energy are left out. Long crests: the mean alone.
/// With 2kR + 20 on the circle (R half the diagonal of the plate) a response is resolved.
/// Throws InputError when 36,000 on the circle do not resolve the spreading.
DirectionGrid direction_grid(const wave::Spreading& spreading, double mean, int least_count);

/// Carries what is known on the full circle to any headings, by trigonometric interpolation: exact
/// for what has fewer than half as many harmonics as there are headings on the circle.
class CircleInterpolation {
 public:
  /// From `circle` equidistant headings, starting at 0, to `heading` [rad].
  CircleInterpolation(const std::vector<double>& heading, int circle);

  /// rows × circle to rows × headings.
  MatXcd operator()(const MatXcd& values) const;

 private:
  std::vector<Index> pick_;  // where every heading is one of the circle's
  MatXd kernel_;             // otherwise, circle × headings
};

/// Weights of the rule of trapezoids on ascending, uneven frequencies [rad/s].
std::vector<double> trapezoid_weights(const std::vector<double>& omega);

/// √(S(ω) w_θ) ξ(θ): amplitudes in the pseudo-excitations of one frequency (E.8), paper (40).
/// `amplitudes` are ξ per metre of wave, q × headings; `density` is S(ω) [m² s/rad].
MatXcd pseudo_amplitudes(const Eigen::Ref<const MatXcd>& amplitudes, double density,
                         const std::vector<double>& weight);

/// Statistics of a response by the pseudo-excitation method, streamed: every frequency is added
/// and dropped, paper (40)–(44). Observed are M quantities y = c^T ξ; what is kept is M spectra and
/// a few q × q matrices, however many waves there were. Same bits for any number of threads.
class PseudoExcitation {
 public:
  static constexpr std::array<int, 4> kOrders = {0, 1, 2, 4};  ///< of the moments

  /// `observed` holds one quantity a row, M × q [unit of the quantity per unit of mode].
  explicit PseudoExcitation(MatXd observed);

  /// Adds one frequency with its weight in the integral over ω. `pseudo`: see pseudo_amplitudes.
  /// Frequencies must ascend; throws InputError otherwise or when a value is not finite.
  void add(double omega, double frequency_weight, const Eigen::Ref<const MatXcd>& pseudo);

  const std::vector<double>& omega() const { return omega_; }  ///< added so far [rad/s]
  /// S_y(ω) of (E.8), M × frequencies [unit² s/rad]; of the k-th time derivative: times ω²ᵏ.
  MatXd spectra() const;
  /// ∫ ω^order S_y dω, M; any order ≥ 0.
  VecXd moment(int order) const;
  /// ∫ ω^order ∑_θ ξ̃* ξ̃ᵀ Δθ dω (E.9), q × q, Hermitian; order one of kOrders.
  const MatXcd& modal_covariance(int order) const;
  /// ∫ ∑_θ y_a* y_b Δθ dω: the covariance of two observed quantities, paper (33). Its real part is
  /// the covariance at the same time.
  Complex cross_covariance(Index a, Index b) const;

 private:
  MatXd observed_;
  std::vector<double> omega_, frequency_weight_;
  std::vector<VecXd> spectrum_;       // one a frequency, M
  std::array<MatXcd, 4> covariance_;  // one of kOrders each
};

/// Standard deviation of y = C ξ at every row of `shape` (N × q) from a modal covariance (q × q):
/// √(c^T Re Σ c). In blocks of rows, so that nothing N × N is formed.
VecXd standard_deviation(const Eigen::Ref<const MatXd>& shape, const MatXcd& covariance);

}  // namespace floe::response
