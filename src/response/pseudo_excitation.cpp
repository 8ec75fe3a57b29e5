#include <floe/numeric/error.hpp>
#include <floe/response/pseudo_excitation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::response {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr int kMostHeadings = 36'000;
constexpr double kEnergyError = 1e-6;

// Headings mean + iΔθ within the lobe, the mean among them
DirectionGrid equidistant(const wave::Spreading& spreading, double mean, int count) {
  const double step = kTurn / count;
  const bool circle = spreading.half_width() > 0.5 * std::numbers::pi;
  const int half = circle ? count / 2 : count / 4;
  DirectionGrid grid;
  for (int i = circle ? 1 - half : -half; i <= half; ++i) {
    const double weight = spreading(i * step) * step;
    if (!(weight > 0.0)) continue;
    grid.heading.push_back(mean + i * step);
    grid.weight.push_back(weight);
  }
  return grid;
}

double energy(const DirectionGrid& grid) {
  double sum = 0.0;
  for (const double weight : grid.weight) sum += weight;
  return sum;
}

}  // namespace

DirectionGrid direction_grid(const wave::Spreading& spreading, double mean, int least_count) {
  if (spreading.long_crested()) return {{mean}, {1.0}};
  // Multiples of four have the ends of a lobe of ±90° among them
  const double resolved = 5.0 * kTurn / std::min(spreading.width(), kTurn);
  int count = 4 * static_cast<int>(std::ceil(std::max<double>(least_count, resolved) / 4.0));
  for (; count <= kMostHeadings; count *= 2) {
    DirectionGrid grid = equidistant(spreading, mean, count);
    if (std::abs(energy(grid) - 1.0) <= kEnergyError) return grid;
  }
  throw InputError("the spreading is too narrow for " + std::to_string(kMostHeadings) +
                   " headings around the circle (use long crests, \"none\")");
}

CircleInterpolation::CircleInterpolation(const std::vector<double>& heading, int circle) {
  FLOE_EXPECT(circle > 0 && circle % 2 == 0);
  const double step = kTurn / circle;
  bool among = true;
  for (const double angle : heading) {
    const double place = angle / step;
    among = among && std::abs(place - std::round(place)) < 1e-9;
    const auto index = static_cast<Index>(std::llround(place)) % circle;
    pick_.push_back(index < 0 ? index + circle : index);
  }
  if (among) return;

  // The interpolant through a unit value at one heading: sin(Mx/2) / (M tan(x/2)), M even
  pick_.clear();
  kernel_.resize(circle, static_cast<Index>(heading.size()));
  for (std::size_t b = 0; b < heading.size(); ++b)
    for (Index j = 0; j < circle; ++j) {
      const double x = std::remainder(heading[b] - static_cast<double>(j) * step, kTurn);
      kernel_(j, static_cast<Index>(b)) =
          std::abs(x) < 1e-12 ? 1.0 : std::sin(0.5 * circle * x) / (circle * std::tan(0.5 * x));
    }
}

MatXcd CircleInterpolation::operator()(const MatXcd& values) const {
  if (kernel_.size() > 0) return values * kernel_.cast<Complex>();
  return values(Eigen::all, pick_);
}

std::vector<double> trapezoid_weights(const std::vector<double>& omega) {
  std::vector<double> weight(omega.size(), 0.0);
  for (std::size_t i = 1; i < omega.size(); ++i) {
    const double half = 0.5 * (omega[i] - omega[i - 1]);
    FLOE_VALIDATE(half > 0.0, "invalid frequencies: " << omega[i] << " rad/s after " << omega[i - 1]
                                                      << " (must ascend)");
    weight[i - 1] += half;
    weight[i] += half;
  }
  return weight;
}

MatXcd pseudo_amplitudes(const Eigen::Ref<const MatXcd>& amplitudes, double density,
                         const std::vector<double>& weight) {
  FLOE_EXPECT(amplitudes.cols() == static_cast<Index>(weight.size()));
  MatXcd pseudo(amplitudes.rows(), amplitudes.cols());
  for (Index b = 0; b < amplitudes.cols(); ++b)
    pseudo.col(b) = std::sqrt(density * weight[static_cast<std::size_t>(b)]) * amplitudes.col(b);
  return pseudo;
}

PseudoExcitation::PseudoExcitation(MatXd observed) : observed_(std::move(observed)) {
  for (MatXcd& matrix : covariance_) matrix = MatXcd::Zero(observed_.cols(), observed_.cols());
}

void PseudoExcitation::add(double omega, double frequency_weight,
                           const Eigen::Ref<const MatXcd>& pseudo) {
  FLOE_EXPECT(pseudo.rows() == observed_.cols());
  FLOE_VALIDATE(
      omega_.empty() || omega > omega_.back(),
      "invalid frequency = " << omega << " rad/s after " << omega_.back() << " (must ascend)");
  FLOE_VALIDATE(pseudo.allFinite(), "amplitudes at omega = " << omega << " rad/s are not finite");

  // NOTE: the products run on one thread each, so their bits do not depend on the threads
  const MatXcd response = observed_.cast<Complex>() * pseudo;
  omega_.push_back(omega);
  frequency_weight_.push_back(frequency_weight);
  spectrum_.push_back(response.rowwise().squaredNorm());
  const MatXcd product = pseudo.conjugate() * pseudo.transpose();
  for (std::size_t i = 0; i < kOrders.size(); ++i)
    covariance_[i] += frequency_weight * std::pow(omega, kOrders[i]) * product;
}

MatXd PseudoExcitation::spectra() const {
  MatXd spectra(observed_.rows(), static_cast<Index>(spectrum_.size()));
  for (std::size_t i = 0; i < spectrum_.size(); ++i)
    spectra.col(static_cast<Index>(i)) = spectrum_[i];
  return spectra;
}

VecXd PseudoExcitation::moment(int order) const {
  VecXd sum = VecXd::Zero(observed_.rows());
  for (std::size_t i = 0; i < omega_.size(); ++i)
    sum += frequency_weight_[i] * std::pow(omega_[i], order) * spectrum_[i];
  return sum;
}

const MatXcd& PseudoExcitation::modal_covariance(int order) const {
  const auto at = std::find(kOrders.begin(), kOrders.end(), order);
  FLOE_VALIDATE(at != kOrders.end(), "invalid order = " << order << " (must be 0, 1, 2 or 4)");
  return covariance_[static_cast<std::size_t>(at - kOrders.begin())];
}

Complex PseudoExcitation::cross_covariance(Index a, Index b) const {
  return (observed_.row(a).cast<Complex>() * covariance_[0] *
          observed_.row(b).transpose().cast<Complex>())
      .value();
}

VecXd standard_deviation(const Eigen::Ref<const MatXd>& shape, const MatXcd& covariance) {
  constexpr Index kRows = 256;  // a block and its product stay in a core's cache
  const MatXd real = covariance.real();
  VecXd deviation(shape.rows());
#pragma omp parallel for schedule(static)
  for (Index first = 0; first < shape.rows(); first += kRows) {
    const Index count = std::min(kRows, shape.rows() - first);
    const auto block = shape.middleRows(first, count);
    const MatXd product = block * real;
    VecXd variance = VecXd::Zero(count);
    for (Index j = 0; j < product.cols(); ++j)
      variance += product.col(j).cwiseProduct(block.col(j));
    deviation.segment(first, count) = variance.cwiseMax(0.0).cwiseSqrt();
  }
  return deviation;
}

}  // namespace floe::response
