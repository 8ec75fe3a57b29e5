#pragma once

#include <floe/numeric/types.hpp>

#include <vector>

namespace floe::response {

/// Spectra of a few quantities with one another, paper (33), streamed as PseudoExcitation: what is
/// kept is one r × r matrix a frequency, however many directions there were.
class CrossSpectra {
 public:
  /// `observed` holds one quantity a row, r × q.
  explicit CrossSpectra(MatXd observed);

  /// Adds one frequency. `pseudo`: see pseudo_amplitudes; `factor` is what the rows leave out of
  /// the quantities, (-iω)ᵏ for the k-th derivative in time.
  void add(const Eigen::Ref<const MatXcd>& pseudo, const VecXcd& factor);

  /// S_ab(ω) = ∑_θ ỹ_a* ỹ_b Δθ (R.5), one Hermitian matrix a frequency. With e^{-iωt}, b lags a by
  /// the angle of S_ab.
  const std::vector<MatXcd>& spectra() const { return spectra_; }

 private:
  MatXd observed_;
  std::vector<MatXcd> spectra_;
};

/// A stationary Gaussian vector of zero mean and its derivative in time, at the same instant.
struct GaussianVector {
  MatXd covariance;             ///< E[a b] = ∫ Re S_ab dω
  MatXd with_derivative;        ///< E[a ḃ] = ∫ ω Im S_ab dω, antisymmetric
  MatXd derivative_covariance;  ///< E[ȧ ḃ] = ∫ ω² Re S_ab dω
};

/// (R.6) from spectra at `omega` [rad/s] with the weights of the integral over it.
GaussianVector gaussian_vector(const std::vector<MatXcd>& spectra, const std::vector<double>& omega,
                               const std::vector<double>& weight);

/// How often a second √(yᵀ A y) rises above `level` > 0, A symmetric and positive semi-definite:
/// the mean rate at which the vector leaves the ellipsoid (R.7), Rice's formula, exact for a
/// Gaussian vector of one to three independent components; relative error 1e-6 or less. [1/s]
double outcrossing_rate(const GaussianVector& vector, const MatXd& form, double level);

/// The level that √(yᵀ A y) exceeds once in `duration` [s] on average; 0 where it never moves.
double most_probable_maximum(const GaussianVector& vector, const MatXd& form, double duration);

}  // namespace floe::response
