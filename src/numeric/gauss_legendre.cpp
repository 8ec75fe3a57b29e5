#include <floe/numeric/error.hpp>
#include <floe/numeric/gauss_legendre.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace floe::numeric {
namespace {

constexpr int kLargest = 64;

QuadratureRule make_rule(int count) {
  QuadratureRule rule{std::vector<double>(count), std::vector<double>(count)};
  for (int i = 0; i < count; ++i) {
    // Newton from the asymptotic root of P_count, in extended precision
    long double x = -std::cos(std::numbers::pi_v<long double> * (i + 0.75L) / (count + 0.5L));
    long double derivative = 1.0L;
    for (int step = 0; step < 8; ++step) {
      long double previous = 1.0L, current = x;
      for (int degree = 2; degree <= count; ++degree) {
        const long double next =
            ((2 * degree - 1) * x * current - (degree - 1) * previous) / degree;
        previous = current;
        current = next;
      }
      derivative = count * (x * current - previous) / (x * x - 1.0L);
      x -= current / derivative;
    }
    rule.node[i] = static_cast<double>(x);
    rule.weight[i] = static_cast<double>(2.0L / ((1.0L - x * x) * derivative * derivative));
  }
  return rule;
}

}  // namespace

const QuadratureRule& gauss_legendre(int count) {
  static const std::array<QuadratureRule, kLargest + 1> rules = [] {
    std::array<QuadratureRule, kLargest + 1> all;
    for (int n = 1; n <= kLargest; ++n) all[n] = make_rule(n);
    return all;
  }();
  FLOE_VALIDATE(count >= 1 && count <= kLargest,
                "invalid Gauss point count = " << count << " (must be 1 to " << kLargest << ")");
  return rules[count];
}

}  // namespace floe::numeric
