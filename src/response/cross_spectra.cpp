#include <floe/numeric/error.hpp>
#include <floe/numeric/gauss_legendre.hpp>
#include <floe/response/cross_spectra.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::response {
namespace {

constexpr double kNothing = 1e-12;  // of the largest variance: a component that does not move

// The vector in coordinates in which the ellipsoid is a ball, without components that do not move
struct BallVector {
  VecXd deviation;  // covariance is diagonal
  MatXd drift;      // E[u̇ | u] = drift u
  MatXd spread;     // covariance of u̇ given u
};

BallVector ball_vector(const GaussianVector& vector, const MatXd& form) {
  // u = A^{1/2} y, turned onto the axes of its covariance
  const Eigen::SelfAdjointEigenSolver<MatXd> of_form(form);
  const VecXd root = of_form.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const MatXd to_ball = root.asDiagonal() * of_form.eigenvectors().transpose();
  const Eigen::SelfAdjointEigenSolver<MatXd> axes(to_ball * vector.covariance *
                                                  to_ball.transpose());
  const VecXd variance = axes.eigenvalues();
  const double least = kNothing * std::max(variance.maxCoeff(), 0.0);
  const Index moving = (variance.array() > least).count();
  const MatXd turn = axes.eigenvectors().rightCols(moving).transpose() * to_ball;

  // What u tells of its derivative, and what it leaves open
  BallVector ball;
  ball.deviation = variance.tail(moving).cwiseSqrt();
  const MatXd with_derivative = turn * vector.with_derivative * turn.transpose();  // E[u_i u̇_j]
  ball.drift = with_derivative.transpose() * ball.deviation.cwiseAbs2().cwiseInverse().asDiagonal();
  ball.spread =
      turn * vector.derivative_covariance * turn.transpose() - ball.drift * with_derivative;
  return ball;
}

// E[max(x, 0)] of a Gaussian x
double positive_part(double mean, double deviation) {
  if (!(deviation > 0.0)) return std::max(mean, 0.0);
  const double z = mean / deviation;
  return deviation * std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi) +
         0.5 * mean * std::erfc(-z / std::numbers::sqrt2);
}

using Small = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;

// Flow out of the ball through the piece of its surface on which a unit sphere of directions m is
// mapped by n = σm/|σm|: peaked where m is, not where the smallest deviation puts it
double flow(const BallVector& ball, const Small& m, double level) {
  const Small mapped = ball.deviation.cwiseProduct(m);
  const double length = mapped.norm();
  const Small n = mapped / length;
  const double mean = level * n.dot(ball.drift * n);
  const double variance = n.dot(ball.spread * n);
  const auto dimension = static_cast<double>(m.size());
  const double reach = level / length;
  return std::pow(reach, dimension) / level * std::exp(-0.5 * reach * reach) *
         std::pow(2.0 * std::numbers::pi, -0.5 * dimension) *
         positive_part(mean, std::sqrt(std::max(variance, 0.0)));
}

constexpr int kAround = 180;  // directions around the circle; opposite ones are the same
constexpr int kAcross = 64;   // Gauss points from pole to pole

}  // namespace

CrossSpectra::CrossSpectra(MatXd observed) : observed_(std::move(observed)) {}

void CrossSpectra::add(const Eigen::Ref<const MatXcd>& pseudo, const VecXcd& factor) {
  FLOE_EXPECT(pseudo.rows() == observed_.cols() && factor.size() == observed_.rows());
  const MatXcd response = factor.asDiagonal() * (observed_.cast<Complex>() * pseudo);
  spectra_.emplace_back(response.conjugate() * response.transpose());
}

GaussianVector gaussian_vector(const std::vector<MatXcd>& spectra, const std::vector<double>& omega,
                               const std::vector<double>& weight) {
  FLOE_EXPECT(spectra.size() == omega.size() && weight.size() == omega.size());
  const Index size = spectra.empty() ? 0 : spectra.front().rows();
  GaussianVector vector{MatXd::Zero(size, size), MatXd::Zero(size, size), MatXd::Zero(size, size)};
  for (std::size_t i = 0; i < omega.size(); ++i) {
    vector.covariance += weight[i] * spectra[i].real();
    vector.with_derivative += weight[i] * omega[i] * spectra[i].imag();
    vector.derivative_covariance += weight[i] * omega[i] * omega[i] * spectra[i].real();
  }
  return vector;
}

double outcrossing_rate(const GaussianVector& vector, const MatXd& form, double level) {
  FLOE_VALIDATE(level > 0.0, "invalid level = " << level << " (must be positive)");
  const BallVector ball = ball_vector(vector, form);
  const Index dimension = ball.deviation.size();
  FLOE_VALIDATE(dimension <= 3,
                "invalid count of components = " << dimension << " (must be at most 3)");
  if (dimension == 0) return 0.0;
  if (dimension == 1) return 2.0 * flow(ball, Small{{1.0}}, level);

  // The surface of the ball, by Gauss points from pole to pole and equal steps around
  const double step = 2.0 * std::numbers::pi / kAround;
  double rate = 0.0;
  for (int i = 0; i < kAround / 2; ++i) {
    const double x = std::cos(i * step), y = std::sin(i * step);
    if (dimension == 2) {
      rate += 2.0 * step * flow(ball, Small{{x, y}}, level);
      continue;
    }
    const auto& gauss = numeric::gauss_legendre(kAcross);
    for (int j = 0; j < kAcross; ++j) {
      const double z = gauss.node[j], r = std::sqrt(1.0 - z * z);
      rate += 2.0 * step * gauss.weight[j] * flow(ball, Small{{r * x, r * y, z}}, level);
    }
  }
  return rate;
}

double most_probable_maximum(const GaussianVector& vector, const MatXd& form, double duration) {
  FLOE_VALIDATE(duration > 0.0, "invalid duration = " << duration << " s (must be positive)");
  const double mean_square = (form * vector.covariance).trace();
  if (!(mean_square > 0.0)) return 0.0;

  // Above its largest the rate falls with the level: halve the interval between a level that is
  // exceeded more often than once and one that is not
  double low = std::sqrt(mean_square), high = low;
  if (outcrossing_rate(vector, form, low) * duration < 1.0) return low;
  while (outcrossing_rate(vector, form, high) * duration > 1.0) high *= 1.5;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (outcrossing_rate(vector, form, middle) * duration > 1.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace floe::response
