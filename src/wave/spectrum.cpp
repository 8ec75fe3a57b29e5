#include <floe/numeric/error.hpp>
#include <floe/wave/spectrum.hpp>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace floe::wave {
namespace {

void require_positive(double value, const char* what, const char* unit) {
  FLOE_VALIDATE(std::isfinite(value) && value > 0.0,
                "invalid " << what << " = " << value << " " << unit << " (must be positive)");
}

}  // namespace

Spectrum Spectrum::bretschneider(double significant_height, double significant_period) {
  require_positive(significant_height, "significant_height", "m");
  require_positive(significant_period, "significant_period", "s");

  // (E.1), with ω/2π the frequency in Hz: A ω⁻⁵ exp(-B ω⁻⁴), whose variance is A/4B
  const double turn = 2.0 * std::numbers::pi;
  const double b = 1.03 * std::pow(turn / significant_period, 4);
  Spectrum spectrum;
  spectrum.tail_ = 0.257 * std::pow(significant_height, 2) / turn *
                   std::pow(significant_period, -4) * std::pow(turn, 5);
  spectrum.peak_ = std::pow(0.8 * b, 0.25);
  spectrum.decay_ = 1.25;
  spectrum.m0_ = spectrum.tail_ / (4.0 * b);
  return spectrum;
}

Spectrum Spectrum::pierson_moskowitz(double significant_height, double peak_period) {
  return jonswap(significant_height, peak_period, 1.0);
}

Spectrum Spectrum::jonswap(double significant_height, double peak_period, double gamma) {
  require_positive(significant_height, "significant_height", "m");
  require_positive(peak_period, "peak_period", "s");
  FLOE_VALIDATE(std::isfinite(gamma) && gamma >= 1.0 && gamma <= 20.0,
                "invalid gamma = " << gamma << " (must be 1 to 20)");
  Spectrum spectrum;
  spectrum.peak_ = 2.0 * std::numbers::pi / peak_period;
  spectrum.decay_ = 1.25;
  spectrum.gamma_ = gamma;
  spectrum.tail_ = 1.0;
  spectrum.m0_ = std::pow(significant_height, 2) / 16.0;
  spectrum.tail_ = spectrum.m0_ / spectrum.variance(0.0, std::numeric_limits<double>::infinity());
  return spectrum;
}

Spectrum Spectrum::tabulated(std::vector<double> omega, std::vector<double> density) {
  FLOE_VALIDATE(omega.size() >= 2 && omega.size() == density.size(),
                "invalid spectrum table: " << omega.size() << " frequencies and " << density.size()
                                           << " values (must be as many, two or more)");
  for (std::size_t i = 0; i < omega.size(); ++i) {
    const bool ascending = i == 0 ? omega[i] >= 0.0 : omega[i] > omega[i - 1];
    FLOE_VALIDATE(std::isfinite(omega[i]) && ascending,
                  "invalid spectrum table: omega = " << omega[i] << " rad/s in row " << i + 1
                                                     << " (must ascend)");
    FLOE_VALIDATE(std::isfinite(density[i]) && density[i] >= 0.0,
                  "invalid spectrum table: S = " << density[i] << " in row " << i + 1
                                                 << " (must be at least 0)");
  }
  Spectrum spectrum;
  spectrum.omega_ = std::move(omega);
  spectrum.density_ = std::move(density);
  spectrum.m0_ = spectrum.variance(0.0, std::numeric_limits<double>::infinity());
  FLOE_VALIDATE(spectrum.m0_ > 0.0, "invalid spectrum table: all values are 0");
  return spectrum;
}

double Spectrum::operator()(double omega) const {
  if (omega_.empty()) return omega > 0.0 ? tail_ * shape(omega) : 0.0;
  const auto upper = std::lower_bound(omega_.begin(), omega_.end(), omega);
  if (upper == omega_.end() || omega < omega_.front()) return 0.0;
  const auto i = static_cast<std::size_t>(upper - omega_.begin());
  if (i == 0) return density_.front();
  const double share = (omega - omega_[i - 1]) / (omega_[i] - omega_[i - 1]);
  return density_[i - 1] + share * (density_[i] - density_[i - 1]);
}

double Spectrum::shape(double omega) const {
  const double ratio = peak_ / omega;
  const double exponent = decay_ * std::pow(ratio, 4);
  if (exponent > 700.0) return 0.0;
  double value = std::pow(omega, -5) * std::exp(-exponent);
  if (gamma_ != 1.0) {
    const double sigma = omega <= peak_ ? 0.07 : 0.09;
    value *= std::pow(gamma_, std::exp(-0.5 * std::pow((omega / peak_ - 1.0) / sigma, 2)));
  }
  return value;
}

double Spectrum::variance(double from, double to) const { return integral(0, from, to); }

double Spectrum::moment(int order) const {
  FLOE_VALIDATE(order >= -1 && order <= 2,
                "invalid order = " << order << " (must be -1, 0, 1 or 2)");
  return integral(order, 0.0, std::numeric_limits<double>::infinity());
}

double Spectrum::integral(int order, double from, double to) const {
  if (!(to > from)) return 0.0;
  if (!omega_.empty()) return table_integral(order, from, to);

  // Pieces that meet where the peak enhancement has its kink; the far tail in closed form (E.4)
  const double far = 20.0 * peak_;
  const double pieces[] = {0.0,         0.5 * peak_, 0.8 * peak_, 0.9 * peak_, peak_,
                           1.1 * peak_, 1.3 * peak_, 2.0 * peak_, 5.0 * peak_, far};
  double sum = 0.0;
  for (std::size_t i = 1; i < std::size(pieces); ++i) {
    const double a = std::max(from, pieces[i - 1]), b = std::min(to, pieces[i]);
    if (b > a)
      sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
          [this, order](double omega) { return std::pow(omega, order) * (*this)(omega); }, a, b, 5,
          1e-10);
  }
  const auto beyond = [this, order](double omega) {
    if (std::isinf(omega)) return 0.0;
    const double rest = decay_ * std::pow(peak_ / omega, 4);
    if (order == 0) return -std::expm1(-rest) / (4.0 * decay_ * std::pow(peak_, 4)) * tail_;
    // NOTE: two terms of the series of exp(-rest), 7.8e-6 at `far`
    return tail_ * std::pow(omega, order - 4) * (1.0 / (4 - order) - rest / (8 - order));
  };
  if (to > far) sum += beyond(std::max(from, far)) - beyond(to);
  return sum;
}

// Straight lines between the table's frequencies and the two ends
double Spectrum::table_integral(int order, double from, double to) const {
  std::vector<double> stations = {std::max(from, omega_.front()), std::min(to, omega_.back())};
  if (stations[1] <= stations[0]) return 0.0;
  for (const double omega : omega_)
    if (omega > stations[0] && omega < stations[1]) stations.push_back(omega);
  std::sort(stations.begin(), stations.end());
  double sum = 0.0;
  for (std::size_t i = 1; i < stations.size(); ++i) {
    const double a = stations[i - 1], b = stations[i];
    if (order == 0)
      sum += 0.5 * (b - a) * ((*this)(a) + (*this)(b));
    else
      sum += boost::math::quadrature::gauss_kronrod<double, 15>::integrate(
          [this, order](double omega) { return std::pow(omega, order) * (*this)(omega); }, a, b, 0);
  }
  return sum;
}

}  // namespace floe::wave
