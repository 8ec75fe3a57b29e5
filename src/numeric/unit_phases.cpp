#include <floe/numeric/simd.hpp>
#include <floe/numeric/unit_phases.hpp>

namespace floe::numeric {
namespace {

// π/2 in three parts; the first two have 30 bits or less, so that n times them is exact for n < 2²³
constexpr double kFirst = 0x1.921fb54p+0;
constexpr double kSecond = 0x1.10b46118p-30;
constexpr double kThird = 0x1.313198a2e037p-61;
constexpr double kPerQuarter = 0x1.45f306dc9c883p-1;
// Adding and subtracting it rounds to the nearest integer, which is then in the low bits
constexpr double kRound = 0x1.8p52;

}  // namespace

// NOTE: Taylor's series up to r¹⁷ and r¹⁶: the next term is below 1e-18 at |r| = π/4
FLOE_SIMD_CLONES void unit_phases(const double* __restrict angle, Index count,
                                  double* __restrict cosine, double* __restrict sine) {
#pragma omp simd
  for (Index i = 0; i < count; ++i) {
    const double quarters = (angle[i] * kPerQuarter + kRound) - kRound;
    double r = angle[i] - quarters * kFirst;
    r -= quarters * kSecond;
    r -= quarters * kThird;
    const double z = r * r;
    double s = 1.0 / 355687428096000.0;
    s = s * z - 1.0 / 1307674368000.0;
    s = s * z + 1.0 / 6227020800.0;
    s = s * z - 1.0 / 39916800.0;
    s = s * z + 1.0 / 362880.0;
    s = s * z - 1.0 / 5040.0;
    s = s * z + 1.0 / 120.0;
    s = s * z - 1.0 / 6.0;
    s = r + r * z * s;
    double c = 1.0 / 20922789888000.0;
    c = c * z - 1.0 / 87178291200.0;
    c = c * z + 1.0 / 479001600.0;
    c = c * z - 1.0 / 3628800.0;
    c = c * z + 1.0 / 40320.0;
    c = c * z - 1.0 / 720.0;
    c = c * z + 1.0 / 24.0;
    c = c * z - 0.5;
    c = 1.0 + z * c;
    // Quarter n mod 4: swap where odd, signs of the quadrant
    const double half = 0.5 * quarters;
    const double odd = 2.0 * (half - ((half + kRound) - kRound));  // 0 or ±1
    const double fourth = 0.25 * (quarters - odd);
    const double turned = 2.0 * (fourth - ((fourth + kRound) - kRound));
    // e^{i angle} = e^{ir} iⁿ with n = odd + 2 turned (mod 4), both in {-1, 0, 1}
    const double flip = 1.0 - 2.0 * turned * turned;
    const double even = 1.0 - odd * odd;
    cosine[i] = flip * (even * c - odd * s);
    sine[i] = flip * (even * s + odd * c);
  }
}

}  // namespace floe::numeric
