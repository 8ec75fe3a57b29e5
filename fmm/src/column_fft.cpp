#include "column_fft.hpp"

#include <floe/numeric/error.hpp>
#include <floe/numeric/simd.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace floe::fmm {
namespace {

using Vector = double __attribute__((vector_size(8 * ColumnFft::kLanes)));

// One element of all columns
struct Element {
  Vector re, im;
};

[[gnu::always_inline]] inline void add(const Element& a, const Element& b, Element& sum) {
  sum.re = a.re + b.re;
  sum.im = a.im + b.im;
}
[[gnu::always_inline]] inline void subtract(const Element& a, const Element& b,
                                            Element& difference) {
  difference.re = a.re - b.re;
  difference.im = a.im - b.im;
}
// a - s·i·b and a + s·i·b, s = ±1 the direction
[[gnu::always_inline]] inline void turn(const Element& a, const Element& b, double s,
                                        Element& minus, Element& plus) {
  const Vector re = s * b.im, im = s * b.re;
  minus.re = a.re + re;
  minus.im = a.im - im;
  plus.re = a.re - re;
  plus.im = a.im + im;
}

// The DFTs of a few elements, in place: x[k] = Σ_j x[j] e^{-s·2πi jk/radix}
template <int radix>
struct Dft {
  // Odd radix: sums and differences over j and radix - j
  [[gnu::always_inline]] static inline void transform(Element* x, double s) {
    constexpr int kHalf = radix / 2;
    Element sum[kHalf], difference[kHalf];
    for (int j = 1; j <= kHalf; ++j) {
      add(x[j], x[radix - j], sum[j - 1]);
      subtract(x[j], x[radix - j], difference[j - 1]);
    }
    const Element first = x[0];
    for (int j = 0; j < kHalf; ++j) add(x[0], sum[j], x[0]);
    for (int k = 1; k <= kHalf; ++k) {
      Element even = first, odd{};
      for (int j = 1; j <= kHalf; ++j) {
        const double c = cosine(j * k % radix), d = sine(j * k % radix);
        even.re += c * sum[j - 1].re;
        even.im += c * sum[j - 1].im;
        odd.re += d * difference[j - 1].re;
        odd.im += d * difference[j - 1].im;
      }
      turn(even, odd, s, x[k], x[radix - k]);
    }
  }

 private:
  static constexpr double kCosine3[] = {1.0, -0.5};
  static constexpr double kCosine5[] = {1.0, 0.30901699437494742410, -0.80901699437494742410};
  static constexpr double kCosine7[] = {1.0, 0.62348980185873353053, -0.22252093395631440429,
                                        -0.90096886790241912624};
  static constexpr double kSine3[] = {0.0, 0.86602540378443864676};
  static constexpr double kSine5[] = {0.0, 0.95105651629515357212, 0.58778525229247312917};
  static constexpr double kSine7[] = {0.0, 0.78183148246802980871, 0.97492791218182360702,
                                      0.43388373911755812048};
  static constexpr double cosine(int k) {
    const int m = 2 * k > radix ? radix - k : k;
    return radix == 3 ? kCosine3[m] : radix == 5 ? kCosine5[m] : kCosine7[m];
  }
  static constexpr double sine(int k) {
    const int m = 2 * k > radix ? radix - k : k;
    const double value = radix == 3 ? kSine3[m] : radix == 5 ? kSine5[m] : kSine7[m];
    return 2 * k > radix ? -value : value;
  }
};

template <>
struct Dft<2> {
  [[gnu::always_inline]] static inline void transform(Element* x, double) {
    const Element a = x[0], b = x[1];
    add(a, b, x[0]);
    subtract(a, b, x[1]);
  }
};

template <>
struct Dft<4> {
  [[gnu::always_inline]] static inline void transform(Element* x, double s) {
    Element a, b, c, d;
    add(x[0], x[2], a);
    subtract(x[0], x[2], b);
    add(x[1], x[3], c);
    subtract(x[1], x[3], d);
    add(a, c, x[0]);
    subtract(a, c, x[2]);
    turn(b, d, s, x[1], x[3]);
  }
};

[[gnu::always_inline]] inline void load(const double* from, Element& to) {
  __builtin_memcpy(&to.re, from, sizeof(Vector));
  __builtin_memcpy(&to.im, from + ColumnFft::kLanes, sizeof(Vector));
}
[[gnu::always_inline]] inline void store(const Element& from, double* to) {
  __builtin_memcpy(to, &from.re, sizeof(Vector));
  __builtin_memcpy(to + ColumnFft::kLanes, &from.im, sizeof(Vector));
}

// Groups of `stride` neighbours share the factors that follow the DFT
template <int radix>
[[gnu::always_inline]] inline void run_stage(Index groups, Index stride, const double* twiddle,
                                             double s, const double* from, double* to) {
  constexpr Index kElement = ColumnFft::kElement;
  for (Index p = 0; p < groups; ++p, twiddle += 2 * (radix - 1))
    for (Index q = 0; q < stride; ++q) {
      Element x[radix];
      for (int j = 0; j < radix; ++j) load(from + (q + stride * (p + groups * j)) * kElement, x[j]);
      Dft<radix>::transform(x, s);
      double* const out = to + (q + stride * radix * p) * kElement;
      store(x[0], out);
      for (int k = 1; k < radix; ++k) {
        const double c = twiddle[2 * k - 2], d = s * twiddle[2 * k - 1];
        Element y;
        y.re = c * x[k].re + d * x[k].im;
        y.im = c * x[k].im - d * x[k].re;
        store(y, out + k * stride * kElement);
      }
    }
}

FLOE_SIMD_CLONES void run(int radix, Index groups, Index stride, const double* twiddle, double s,
                          const double* from, double* to) {
  if (radix == 2) run_stage<2>(groups, stride, twiddle, s, from, to);
  if (radix == 3) run_stage<3>(groups, stride, twiddle, s, from, to);
  if (radix == 4) run_stage<4>(groups, stride, twiddle, s, from, to);
  if (radix == 5) run_stage<5>(groups, stride, twiddle, s, from, to);
  if (radix == 7) run_stage<7>(groups, stride, twiddle, s, from, to);
}

}  // namespace

ColumnFft::ColumnFft(Index length) {
  FLOE_VALIDATE(length > 0, "invalid FFT length = " << length << " (must be positive)");
  Index rest = length, stride = 1;
  for (const int radix : {7, 5, 3, 4, 2})
    while (rest % radix == 0) {
      const Index groups = rest / radix;
      stages_.push_back({radix, groups, stride, twiddle_.size()});
      for (Index p = 0; p < groups; ++p)
        for (int k = 1; k < radix; ++k) {
          const double angle =
              2.0 * std::numbers::pi * static_cast<double>(p * k) / static_cast<double>(rest);
          twiddle_.push_back(std::cos(angle));
          twiddle_.push_back(std::sin(angle));
        }
      rest = groups;
      stride *= radix;
    }
  FLOE_VALIDATE(rest == 1, "invalid FFT length = " << length << " (must be 2^a 3^b 5^c 7^d)");
}

void ColumnFft::execute(Direction direction, double* data, double* scratch) const {
  const double s = direction == Direction::forward ? 1.0 : -1.0;
  for (const Stage& stage : stages_) {
    run(stage.radix, stage.groups, stage.stride, twiddle_.data() + stage.twiddle, s, data, scratch);
    std::swap(data, scratch);
  }
}

}  // namespace floe::fmm
