#include "bem/singular_functions.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace floe::bem {

void SingularFunctions::evaluate(std::span<const double> distance, Complex* value) {
  constexpr Index kBlock = 64;
  const auto count = static_cast<Index>(distance.size());
  Eigen::Array<double, kBlock, 1> log;
  for (Index begin = 0; begin < count; begin += kBlock) {
    const Index size = std::min(kBlock, count - begin);
    log.head(size) = Eigen::Map<const Eigen::ArrayXd>(distance.data() + begin, size).log();
    for (Index i = 0; i < size; ++i) {
      const double r = distance[begin + i];
      value[begin + i] = Complex(1.0 / r, log[i]);
      value[count + begin + i] = Complex(r, r * r * log[i]);
    }
  }
}

std::array<double, SingularFunctions::kCount> SingularFunctions::coefficients(double nu) {
  return {2.0, -2.0 * nu, -2.0 * nu * nu, 0.5 * nu * nu * nu};
}

Complex SingularFunctions::rest_at_zero(const green::GreenFunction& green) {
  // The rest is even in R up to the order R³: so far in, it is its limit to 1e-8
  const double r = 1e-4 * std::min(1.0 / green.wavenumber(), green.depth());
  const auto c = coefficients(green.nu());
  return green(r) - c[0] / r - c[1] * std::log(r) - c[2] * r - c[3] * r * r * std::log(r);
}

}  // namespace floe::bem
