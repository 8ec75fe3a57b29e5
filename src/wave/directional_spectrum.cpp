#include <floe/numeric/error.hpp>
#include <floe/wave/directional_spectrum.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::wave {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

}  // namespace

DirectionalSpectrum::DirectionalSpectrum(std::vector<double> omega, std::vector<double> heading,
                                         MatXd density)
    : omega_(std::move(omega)), heading_(std::move(heading)), density_(std::move(density)) {
  FLOE_VALIDATE(omega_.size() >= 2 && heading_.size() >= 3 &&
                    density_.rows() == static_cast<Index>(omega_.size()) &&
                    density_.cols() == static_cast<Index>(heading_.size()),
                "invalid directional spectrum: " << omega_.size() << " frequencies, "
                                                 << heading_.size()
                                                 << " directions (must be 2 and 3 or more)");
  for (std::size_t i = 1; i < omega_.size(); ++i)
    FLOE_VALIDATE(omega_[0] >= 0.0 && omega_[i] > omega_[i - 1] && std::isfinite(omega_[i]),
                  "invalid directional spectrum: omega = " << omega_[i] << " rad/s (must ascend)");
  for (std::size_t j = 1; j < heading_.size(); ++j)
    FLOE_VALIDATE(heading_[j] > heading_[j - 1] && heading_[j] < heading_[0] + kTurn,
                  "invalid directional spectrum: heading = " << heading_[j]
                                                             << " rad (must ascend in a turn)");
  FLOE_VALIDATE(density_.allFinite() && density_.minCoeff() >= 0.0 && density_.maxCoeff() > 0.0,
                "invalid directional spectrum: density (must be at least 0, and not all 0)");
}

// Weights of the rule of trapezoids around the circle
VecXd DirectionalSpectrum::widths() const {
  const std::size_t count = heading_.size();
  VecXd width(static_cast<Index>(count));
  for (std::size_t j = 0; j < count; ++j) {
    const double before = j > 0 ? heading_[j - 1] : heading_.back() - kTurn;
    const double after = j + 1 < count ? heading_[j + 1] : heading_.front() + kTurn;
    width[static_cast<Index>(j)] = 0.5 * (after - before);
  }
  return width;
}

VecXd DirectionalSpectrum::density(double omega) const {
  const auto upper = std::lower_bound(omega_.begin(), omega_.end(), omega);
  if (upper == omega_.end() || omega < omega_.front()) return VecXd::Zero(density_.cols());
  const auto i = static_cast<Index>(upper - omega_.begin());
  if (i == 0) return density_.row(0);
  const double below = omega_[static_cast<std::size_t>(i) - 1];
  const double share = (omega - below) / (*upper - below);
  return (1.0 - share) * density_.row(i - 1) + share * density_.row(i);
}

Spectrum DirectionalSpectrum::over_directions() const {
  const VecXd sum = density_ * widths();
  return Spectrum::tabulated(omega_, {sum.begin(), sum.end()});
}

double DirectionalSpectrum::mean_heading() const {
  const VecXd width = widths();
  double x = 0.0, y = 0.0;
  for (std::size_t i = 0; i < omega_.size(); ++i) {
    const double below = omega_[i > 0 ? i - 1 : i];
    const double above = omega_[i + 1 < omega_.size() ? i + 1 : i];
    for (std::size_t j = 0; j < heading_.size(); ++j) {
      const auto column = static_cast<Index>(j);
      const double energy =
          0.5 * (above - below) * width[column] * density_(static_cast<Index>(i), column);
      x += energy * std::cos(heading_[j]);
      y += energy * std::sin(heading_[j]);
    }
  }
  return std::atan2(y, x);
}

}  // namespace floe::wave
