#include <floe/green/green_table.hpp>
#include <floe/numeric/error.hpp>
#include <floe/numeric/simd.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace floe::green {
namespace {

constexpr int kTerms = 8;         // polynomial coefficients a panel
constexpr int kOctaves = 48;      // range of the table below max_distance
constexpr int kEighthShift = 49;  // exponent and three mantissa bits number an eighth of an octave
constexpr std::size_t kBlock = 64;

using Terms = std::array<Complex, kTerms>;

// Coefficients of 1, t, t² … of the polynomial through f at the Chebyshev points of [-1, 1]
Terms interpolate(const Terms& value) {
  Terms chebyshev{};
  for (int j = 0; j < kTerms; ++j)
    for (int i = 0; i < kTerms; ++i)
      chebyshev[j] += value[i] * ((j == 0 ? 1.0 : 2.0) / kTerms *
                                  std::cos(std::numbers::pi * j * (i + 0.5) / kTerms));
  std::array<double, kTerms> previous{1.0}, current{0.0, 1.0};
  Terms power{chebyshev[0], chebyshev[1]};
  for (int j = 2; j < kTerms; ++j) {
    std::array<double, kTerms> next{};
    for (int i = 0; i < kTerms; ++i) next[i] = (i > 0 ? 2.0 * current[i - 1] : 0.0) - previous[i];
    for (int i = 0; i <= j; ++i) power[i] += chebyshev[j] * next[i];
    previous = current;
    current = next;
  }
  return power;
}

// Where the table is looked up: bounds and offsets as the class keeps them
struct Lookup {
  double uniform_from, panels_per_metre;
  std::int64_t first_octave, uniform_first;
};

// Panel number and local coordinate t in [-1, 1] of each distance
FLOE_SIMD_CLONES void find_panels(const Lookup lookup, const double* distance, std::size_t count,
                                  std::int64_t* panel, double* t) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto bits = std::bit_cast<std::int64_t>(distance[i]);
    const std::int64_t fraction = (bits << 3 & 0x000fffffffffffff) | 0x3ff0000000000000;
    const double steps = (distance[i] - lookup.uniform_from) * lookup.panels_per_metre;
    const std::int64_t step = static_cast<std::int32_t>(steps);
    const bool uniform = steps >= 0.0;
    panel[i] = uniform ? lookup.uniform_first + step : (bits >> kEighthShift) - lookup.first_octave;
    t[i] = uniform ? 2.0 * (steps - static_cast<double>(step)) - 1.0
                   : 2.0 * std::bit_cast<double>(fraction) - 3.0;
  }
}

// Whether all distances lie in the table; false too when one is NaN
FLOE_SIMD_CLONES bool all_within(const double* distance, std::size_t count, double least,
                                 double largest) {
  int outside = 0;
  for (std::size_t i = 0; i < count; ++i)
    outside += !(distance[i] >= least && distance[i] <= largest);
  return outside == 0;
}

using Double8 = double __attribute__((vector_size(64)));
using Double4 = double __attribute__((vector_size(32)));
using Double2 = double __attribute__((vector_size(16)));

// Sums the eight complex terms of each panel's polynomial: four at a time, then across
FLOE_SIMD_CLONES void sum_terms(const double* coefficient, const std::int64_t* panel,
                                const double* t, std::size_t count, double* value) {
  for (std::size_t i = 0; i < count; ++i) {
    Double8 low, high;
    __builtin_memcpy(&low, coefficient + 2 * kTerms * panel[i], sizeof(low));
    __builtin_memcpy(&high, coefficient + 2 * kTerms * panel[i] + kTerms, sizeof(high));
    const double t1 = t[i], t2 = t1 * t1;
    const Double8 four = low + high * (t2 * t2);
    const Double4 upper = __builtin_shufflevector(four, four, 4, 5, 6, 7);
    const Double4 two = __builtin_shufflevector(four, four, 0, 1, 2, 3) + upper * t2;
    const Double2 odd = __builtin_shufflevector(two, two, 2, 3);
    const Double2 one = __builtin_shufflevector(two, two, 0, 1) + odd * t1;
    __builtin_memcpy(value + 2 * i, &one, sizeof(one));
  }
}

}  // namespace

GreenTable::GreenTable(const GreenFunction& green, double max_distance)
    : green_(green), min_distance_(0.0), max_distance_(max_distance) {
  FLOE_VALIDATE(max_distance > 0.0 && std::isfinite(max_distance),
                "invalid table range = " << max_distance << " m (must be positive and finite)");

  // Lay out the panels: eighths of octaves up to a quarter to half a wavelength, then equal widths
  const double wavelength = 2.0 * std::numbers::pi / green.wavenumber();
  const int top = std::ilogb(max_distance) + 1;
  const int change = std::min(std::ilogb(0.5 * wavelength), top);
  const int bottom = std::min(change, top) - kOctaves;
  min_distance_ = std::ldexp(1.0, bottom);
  uniform_from_ = std::ldexp(1.0, change);
  panels_per_metre_ = 8.0 / uniform_from_;
  first_octave_ = std::bit_cast<std::int64_t>(min_distance_) >> kEighthShift;
  uniform_first_ = 8L * kOctaves;
  const auto uniform_count = static_cast<std::int64_t>(
      std::max(0.0, (max_distance_ - uniform_from_) * panels_per_metre_) + 1.0);
  const std::int64_t count = uniform_first_ + uniform_count;

  // Interpolate the exact function on each of them
  coefficient_.resize(2 * kTerms * count);
#pragma omp parallel for schedule(static)
  for (std::int64_t panel = 0; panel < count; ++panel) {
    double start, width;
    if (panel < uniform_first_) {
      start = std::ldexp(1.0 + static_cast<double>(panel % 8) / 8.0,
                         bottom + static_cast<int>(panel / 8));
      width = std::ldexp(0.125, bottom + static_cast<int>(panel / 8));
    } else {
      width = 1.0 / panels_per_metre_;
      start = uniform_from_ + static_cast<double>(panel - uniform_first_) * width;
    }
    Terms value;
    for (int i = 0; i < kTerms; ++i)
      value[i] =
          green_(start + 0.5 * width * (1.0 + std::cos(std::numbers::pi * (i + 0.5) / kTerms)));
    const Terms power = interpolate(value);
    for (int j = 0; j < kTerms; ++j) {
      coefficient_[2 * (kTerms * panel + j)] = power[j].real();
      coefficient_[2 * (kTerms * panel + j) + 1] = power[j].imag();
    }
  }
  for (const double c : coefficient_)
    FLOE_VALIDATE_AS(ConvergenceError, std::isfinite(c),
                     "Green function table is not finite (nu = " << green.nu() << " rad/m, depth = "
                                                                 << green.depth() << " m)");
}

void GreenTable::evaluate(std::span<const double> distance, std::span<Complex> value) const {
  FLOE_EXPECT(distance.size() == value.size());
  const Lookup lookup{uniform_from_, panels_per_metre_, first_octave_, uniform_first_};
  std::array<std::int64_t, kBlock> panel;
  std::array<double, kBlock> t;
  for (std::size_t begin = 0; begin < distance.size(); begin += kBlock) {
    const std::size_t count = std::min(kBlock, distance.size() - begin);
    const double* block = distance.data() + begin;
    if (all_within(block, count, min_distance_, max_distance_)) {
      find_panels(lookup, block, count, panel.data(), t.data());
      sum_terms(coefficient_.data(), panel.data(), t.data(), count,
                reinterpret_cast<double*>(value.data() + begin));
    } else {
      for (std::size_t i = 0; i < count; ++i) value[begin + i] = green_(block[i]);
    }
  }
}

double GreenTable::sampled_error(int samples) const {
  double worst = 0.0;
  for (int i = 0; i < samples; ++i) {
    // The golden ratio spreads the exponents evenly
    const double share = std::fmod(0.5 + i * 0.6180339887498949, 1.0);
    const double distance = max_distance_ * std::exp2(-40.0 * share * share);
    Complex value;
    evaluate({&distance, 1}, {&value, 1});
    const Complex exact = green_(distance);
    worst = std::max(worst, std::abs(value - exact) / std::abs(exact));
  }
  return worst;
}

}  // namespace floe::green
