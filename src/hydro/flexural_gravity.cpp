#include <floe/hydro/flexural_gravity.hpp>
#include <floe/numeric/error.hpp>
#include <floe/wave/dispersion.hpp>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace floe::hydro {

double flexural_wavenumber(double omega, const wave::Water& water,
                           const plate::PlateProperties& properties) {
  FLOE_VALIDATE(omega > 0.0, "invalid omega = " << omega << " rad/s (must be positive)");

  // (H.1) divided by ρ: (bending k⁴ + spring) k tanh kh = ω²
  const double bending = properties.bending_rigidity() / water.density;
  const double spring = water.gravity - properties.surface_mass() / water.density * omega * omega;
  const auto excess = [&](double k) {
    // NOTE: tanh(k h) would be NaN for k = 0 and h = inf
    const double inertia = std::isinf(water.depth) ? k : k * std::tanh(k * water.depth);
    return (bending * std::pow(k, 4) + spring) * inertia - omega * omega;
  };

  // Bracket the root: where the first factor is positive the left side only rises
  double low = spring < 0.0 ? std::pow(-spring / bending, 0.25) : 0.0;
  double high = std::max(2.0 * low, wave::wavenumber(omega, water));
  while (excess(high) < 0.0) {
    low = high;
    high *= 2.0;
  }
  if (excess(high) == 0.0) return high;
  std::uintmax_t steps = 200;
  const auto close = [](double a, double b) { return b - a <= 1e-13 * b; };
  const auto root = boost::math::tools::toms748_solve(excess, low, high, close, steps);
  return 0.5 * (root.first + root.second);
}

}  // namespace floe::hydro
