#include <floe/numeric/error.hpp>
#include <floe/wave/dispersion.hpp>

#include <cmath>
#include <numbers>

namespace floe::wave {
namespace {

void validate(double omega, const Water& water) {
  FLOE_VALIDATE(omega > 0.0 && std::isfinite(omega),
                "invalid omega = " << omega << " rad/s (must be positive and finite)");
  FLOE_VALIDATE(water.depth > 0.0,
                "invalid depth = " << water.depth << " m (must be positive or inf)");
  FLOE_VALIDATE(water.gravity > 0.0,
                "invalid gravity = " << water.gravity << " m/s2 (must be positive)");
}

}  // namespace

double deep_wavenumber(double omega, const Water& water) {
  validate(omega, water);
  return omega * omega / water.gravity;
}

long double wavenumber_extended(double nu, double depth) {
  if (std::isinf(depth)) return nu;

  // Solve x tanh x = νh for x = kh by Newton; the start is within 10 % of the root for any νh
  const long double nu_h = static_cast<long double>(nu) * depth;
  long double x = nu_h / std::sqrt(std::tanh(nu_h));
  for (int step = 0; step < 12; ++step) {
    const long double t = std::tanh(x);
    const long double dx = (x * t - nu_h) / (t + x * (1.0L - t * t));
    x -= dx;
    if (std::abs(dx) <= 1e-19L * x) break;
  }
  return x / depth;
}

double wavenumber(double omega, const Water& water) {
  return static_cast<double>(wavenumber_extended(deep_wavenumber(omega, water), water.depth));
}

double evanescent_wavenumber(int n, double nu, double depth) {
  FLOE_VALIDATE(n >= 1, "invalid evanescent mode n = " << n << " (must be at least 1)");
  FLOE_VALIDATE(std::isfinite(depth) && depth > 0.0,
                "invalid depth = " << depth << " m (must be positive and finite)");

  // Solve x = nπ - atan(νh/x): Newton on a function whose slope stays above a positive bound
  const double nu_h = nu * depth;
  const double target = n * std::numbers::pi;
  double x = target - std::atan(nu_h / target);
  for (int step = 0; step < 30; ++step) {
    const double slope = 1.0 - nu_h / (x * x + nu_h * nu_h);
    const double dx = (x + std::atan(nu_h / x) - target) / slope;
    x -= dx;
    if (std::abs(dx) <= 2e-16 * x) break;
  }
  return x / depth;
}

double group_velocity(double omega, const Water& water) {
  const double k = wavenumber(omega, water);
  if (std::isinf(water.depth)) return 0.5 * omega / k;
  const double kh = k * water.depth;
  const double ratio = kh > 350.0 ? 0.0 : 2.0 * kh / std::sinh(2.0 * kh);
  return 0.5 * omega / k * (1.0 + ratio);
}

double angular_frequency(double wavenumber, const Water& water) {
  FLOE_VALIDATE(wavenumber > 0.0 && std::isfinite(wavenumber),
                "invalid wavenumber = " << wavenumber << " rad/m (must be positive and finite)");
  return std::sqrt(water.gravity * wavenumber * std::tanh(wavenumber * water.depth));
}

}  // namespace floe::wave
