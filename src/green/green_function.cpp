#include <floe/green/green_function.hpp>
#include <floe/numeric/error.hpp>
#include <floe/numeric/gauss_legendre.hpp>
#include <floe/wave/dispersion.hpp>

#include <boost/math/special_functions/bessel.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace floe::green {
namespace {

using std::numbers::pi;

// NOTE: Boost's default policy computes K0 in long double, seven times slower.
double bessel_k0(double x) {
  using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  return x > 700.0 ? 0.0 : boost::math::cyl_bessel_k(0, x, Policy());
}

constexpr int kGregoryStart = 40;     // first term of (G.3) that the tail replaces
constexpr int kGregoryOrder = 16;     // differences in its end correction
constexpr double kSeriesFrom = 0.4;   // R/h above which (G.3) is summed as it stands
constexpr double kNegligible = 42.0;  // e^-42 = 6e-19

// Weights on g(M), g(M+1), … of Σ_{n≥M} g(n) - ∫_M^∞ g dn (G.6): Gregory's coefficients, those of
// x/ln(1+x), on the forward differences of g.
const std::array<double, kGregoryOrder>& gregory_weights() {
  static const std::array<double, kGregoryOrder> weights = [] {
    std::array<double, kGregoryOrder + 1> coefficient{1.0};
    for (int n = 1; n <= kGregoryOrder; ++n)
      for (int k = 1; k <= n; ++k)
        coefficient[n] -= (k % 2 == 0 ? 1.0 : -1.0) / (k + 1) * coefficient[n - k];
    std::array<double, kGregoryOrder> sum{};
    for (int j = 0; j < kGregoryOrder; ++j) {
      double binomial = 1.0;
      for (int i = 0; i <= j; ++i) {
        sum[i] += coefficient[j + 1] * binomial * ((j - i) % 2 == 0 ? 1.0 : -1.0);
        binomial *= static_cast<double>(j - i) / (i + 1);
      }
    }
    return sum;
  }();
  return weights;
}

// ∫ f over [start, end] by Gauss points
template <typename Function>
double integrate(double start, double end, int points, Function f) {
  const auto& rule = numeric::gauss_legendre(points);
  double sum = 0.0;
  for (int i = 0; i < points; ++i)
    sum += rule.weight[i] * f(0.5 * (start + end) + 0.5 * (end - start) * rule.node[i]);
  return 0.5 * (end - start) * sum;
}

// K0 at the Gauss points of the octaves below kNegligible, which are the same at every distance
class TailNodes {
 public:
  static constexpr int kPoints = 16;   // an octave
  static constexpr int kOctaves = 64;  // the distances of tables need 50

  TailNodes() {
    const auto& rule = numeric::gauss_legendre(kPoints);
    double end = kNegligible;
    for (int octave = 0; octave < kOctaves; ++octave, end *= 0.5)
      for (int i = 0; i < kPoints; ++i) {
        const double u = end * (0.75 + 0.25 * rule.node[i]);
        square_.push_back(u * u);
        weighted_.push_back(0.25 * end * rule.weight[i] * bessel_k0(u));
      }
  }

  // ∫ K0(u) / (1 + (x/u)²) du from `start` on  (G.5)
  double integrate_from(double start, double x) const {
    double end = kNegligible, sum = 0.0;
    for (int octave = 0; octave < kOctaves && start <= 0.5 * end; ++octave, end *= 0.5)
      for (int i = octave * kPoints; i < (octave + 1) * kPoints; ++i)
        sum += weighted_[i] * (square_[i] / (square_[i] + x * x));
    for (; start < end; end = std::max(start, 0.5 * end))
      sum += integrate(std::max(start, 0.5 * end), end, kPoints,
                       [x](double u) { return bessel_k0(u) / (1.0 + (x / u) * (x / u)); });
    return sum;
  }

 private:
  std::vector<double> square_, weighted_;  // u² and K0(u) times the weight
};

}  // namespace

GreenFunction::GreenFunction(double nu, double depth)
    : nu_(nu), depth_(depth), wavenumber_(0.0L), wave_amplitude_(0.0) {
  FLOE_VALIDATE(nu > 0.0 && std::isfinite(nu),
                "invalid nu = " << nu << " rad/m (must be positive and finite)");
  FLOE_VALIDATE(depth > 0.0, "invalid depth = " << depth << " m (must be positive or inf)");
  wavenumber_ = wave::wavenumber_extended(nu, depth);
  const double k = wavenumber();
  if (std::isinf(depth)) {
    wave_amplitude_ = 2.0 * pi * nu;
    return;
  }

  // NOTE: k² - ν² = k²/cosh²kh; the difference itself would cancel in deep water
  const double kh = k * depth;
  const double sech = kh > 350.0 ? 0.0 : 1.0 / std::cosh(kh);
  wave_amplitude_ = 2.0 * pi * k * k / (depth * k * k * sech * sech + nu);
  const int count = kGregoryStart + kGregoryOrder;
  for (int n = 1; n < count; ++n) {
    const double kn = wave::evanescent_wavenumber(n, nu, depth);
    evanescent_.push_back(kn);
    evanescent_amplitude_.push_back(kn * kn / (depth * (kn * kn + nu * nu) - nu));
  }
}

Complex GreenFunction::operator()(double distance) const {
  FLOE_VALIDATE(distance >= 0.0, "invalid distance = " << distance << " m (must not be negative)");
  if (distance == 0.0) return {std::numeric_limits<double>::infinity(), wave_amplitude_};
  if (std::isinf(distance)) return {0.0, 0.0};

  // NOTE: at kR = 1e6 the rounding of kR alone would cost ten digits of phase; the rest of the
  // extended product enters to first order, H0' = -H1.
  const long double argument = wavenumber_ * distance;
  const double x = static_cast<double>(argument);
  const double rest = static_cast<double>(argument - x);
  const double j = ::j0(x) - rest * ::j1(x);
  const double y = ::y0(x) - (x > 1.0 ? rest * ::y1(x) : 0.0);
  return {remainder(distance) - wave_amplitude_ * y, wave_amplitude_ * j};
}

double GreenFunction::remainder(double distance) const {
  if (std::isinf(depth_)) return remainder_infinite_depth(distance);
  return distance > kSeriesFrom * depth_ ? remainder_series(distance) : remainder_near(distance);
}

double GreenFunction::remainder_series(double distance) const {
  double sum = 0.0;
  for (std::size_t n = 0; n < evanescent_.size(); ++n) {
    const double x = evanescent_[n] * distance;
    if (x > kNegligible + evanescent_[0] * distance) break;
    sum += evanescent_amplitude_[n] * bessel_k0(x);
  }
  return 4.0 * sum;
}

double GreenFunction::remainder_near(double distance) const {
  // Sum the first terms as they stand, the next ones with Gregory's weights (G.6)
  const auto& gregory = gregory_weights();
  double sum = 0.0;
  for (int n = 1; n < kGregoryStart + kGregoryOrder; ++n) {
    const double weight = n < kGregoryStart ? 1.0 : gregory[n - kGregoryStart];
    sum += weight * evanescent_amplitude_[n - 1] * bessel_k0(evanescent_[n - 1] * distance);
  }

  // Add the integral that stands for all the others (G.5), over u = kR
  static const TailNodes tail;
  const double start = evanescent_[kGregoryStart - 1] * distance;
  return 4.0 * sum + 4.0 / (pi * distance) * tail.integrate_from(start, nu_ * distance);
}

double GreenFunction::remainder_infinite_depth(double distance) const {
  // 2ν ∫ e^{-νRt} (1 - 1/√(1+t²)) dt over t from 0 (G.7), the bracket written without cancellation
  const double x = nu_ * distance;
  const auto integrand = [x](double t) {
    const double root = std::sqrt(1.0 + t * t);
    return std::exp(-x * t) * t * t / (root * (1.0 + root));
  };
  double end = std::min(1.0, 4.0 / x);
  double sum = integrate(0.0, end, 20, integrand);
  for (; end < kNegligible / x; end *= 2.0) sum += integrate(end, 2.0 * end, 16, integrand);
  return 2.0 * nu_ * sum;
}

}  // namespace floe::green
