#include "pfft/lane_fft.hpp"

#include <floe/numeric/error.hpp>
#include <floe/numeric/simd.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::fmm::pfft {
namespace {

// Offsets of real and imaginary parts within an element; exchanged, a transform runs backward
struct Parts {
  Index re, im;
};

enum class Zero { none, second_half };  // of the inputs
enum class Wanted { all, first_half };  // of the outputs

// A radix's elements
template <class Real, int kRadix>
struct Butterfly {
  using V = Lanes<Real>;
  V re[kRadix], im[kRadix];

  FLOE_INLINE void transform() {
    if constexpr (kRadix == 2) two();
    if constexpr (kRadix == 3) three();
    if constexpr (kRadix == 4) four();
    if constexpr (kRadix == 5) five();
  }

  FLOE_INLINE void two() {
    const V r = re[0] - re[1], i = im[0] - im[1];
    re[0] += re[1], im[0] += im[1];
    re[1] = r, im[1] = i;
  }

  FLOE_INLINE void three() {
    constexpr Real kSine = static_cast<Real>(0.86602540378443864676);
    const V sum_re = re[1] + re[2], sum_im = im[1] + im[2];
    const V turned_re = kSine * (im[1] - im[2]), turned_im = kSine * (re[2] - re[1]);
    const V middle_re = re[0] - Real(0.5) * sum_re, middle_im = im[0] - Real(0.5) * sum_im;
    re[0] += sum_re, im[0] += sum_im;
    re[1] = middle_re + turned_re, im[1] = middle_im + turned_im;
    re[2] = middle_re - turned_re, im[2] = middle_im - turned_im;
  }

  FLOE_INLINE void four() {
    const V even_re = re[0] + re[2], even_im = im[0] + im[2];
    const V odd_re = re[1] + re[3], odd_im = im[1] + im[3];
    const V difference_re = re[0] - re[2], difference_im = im[0] - im[2];
    const V turned_re = im[1] - im[3], turned_im = re[3] - re[1];
    re[0] = even_re + odd_re, im[0] = even_im + odd_im;
    re[1] = difference_re + turned_re, im[1] = difference_im + turned_im;
    re[2] = even_re - odd_re, im[2] = even_im - odd_im;
    re[3] = difference_re - turned_re, im[3] = difference_im - turned_im;
  }

  FLOE_INLINE void five() {
    constexpr Real kCos1 = static_cast<Real>(0.30901699437494742410);
    constexpr Real kCos2 = static_cast<Real>(-0.80901699437494742410);
    constexpr Real kSin1 = static_cast<Real>(0.95105651629515357212);
    constexpr Real kSin2 = static_cast<Real>(0.58778525229247312917);
    const V a_re = re[1] + re[4], a_im = im[1] + im[4], b_re = re[2] + re[3], b_im = im[2] + im[3];
    const V c_re = re[1] - re[4], c_im = im[1] - im[4], d_re = re[2] - re[3], d_im = im[2] - im[3];
    const V outer_re = re[0] + kCos1 * a_re + kCos2 * b_re;
    const V outer_im = im[0] + kCos1 * a_im + kCos2 * b_im;
    const V inner_re = re[0] + kCos2 * a_re + kCos1 * b_re;
    const V inner_im = im[0] + kCos2 * a_im + kCos1 * b_im;
    const V p_re = kSin1 * c_re + kSin2 * d_re, p_im = kSin1 * c_im + kSin2 * d_im;
    const V q_re = kSin2 * c_re - kSin1 * d_re, q_im = kSin2 * c_im - kSin1 * d_im;
    re[0] += a_re + b_re, im[0] += a_im + b_im;
    re[1] = outer_re + p_im, im[1] = outer_im - p_re;
    re[2] = inner_re + q_im, im[2] = inner_im - q_re;
    re[3] = inner_re - q_im, im[3] = inner_im + q_re;
    re[4] = outer_re - p_im, im[4] = outer_im + p_re;
  }
};

template <class Real, int kRadix, Zero kZero, Wanted kWanted>
FLOE_INLINE void run_pass(const Real* x, Real* y, Index groups, Index stride, const Real* twiddle,
                          Parts parts) {
  constexpr Index kElement = 2 * kLanes<Real>;
  constexpr int kGiven = kZero == Zero::none ? kRadix : kRadix / 2;
  constexpr int kResults = kWanted == Wanted::all ? kRadix : kRadix / 2;
  using V = Lanes<Real>;
  for (Index p = 0; p < groups; ++p, twiddle += 2 * (kRadix - 1))
    for (Index q = 0; q < stride; ++q) {
      Butterfly<Real, kRadix> b;
      for (int k = 0; k < kGiven; ++k) {
        const Real* const from = x + kElement * (q + stride * (p + groups * k));
        load(b.re[k], from + parts.re);
        load(b.im[k], from + parts.im);
      }
      for (int k = kGiven; k < kRadix; ++k) b.re[k] = b.im[k] = V{};
      b.transform();
      Real* const to = y + kElement * (q + stride * kRadix * p);
      store(to + parts.re, b.re[0]);
      store(to + parts.im, b.im[0]);
      for (int k = 1; k < kResults; ++k) {
        const Real cosine = twiddle[2 * k - 2], sine = twiddle[2 * k - 1];
        const V re = cosine * b.re[k] - sine * b.im[k];
        const V im = cosine * b.im[k] + sine * b.re[k];
        store(to + kElement * stride * k + parts.re, re);
        store(to + kElement * stride * k + parts.im, im);
      }
    }
}

template <class Real>
FLOE_INLINE void run_any(int radix, Zero zero, Wanted wanted, const Real* x, Real* y, Index groups,
                         Index stride, const Real* twiddle, Parts parts) {
  if (zero == Zero::second_half && wanted == Wanted::first_half)
    return run_pass<Real, 4, Zero::second_half, Wanted::first_half>(x, y, groups, stride, twiddle,
                                                                    parts);
  if (zero == Zero::second_half)
    return run_pass<Real, 4, Zero::second_half, Wanted::all>(x, y, groups, stride, twiddle, parts);
  if (wanted == Wanted::first_half)
    return run_pass<Real, 4, Zero::none, Wanted::first_half>(x, y, groups, stride, twiddle, parts);
  switch (radix) {
    case 2:
      return run_pass<Real, 2, Zero::none, Wanted::all>(x, y, groups, stride, twiddle, parts);
    case 3:
      return run_pass<Real, 3, Zero::none, Wanted::all>(x, y, groups, stride, twiddle, parts);
    case 4:
      return run_pass<Real, 4, Zero::none, Wanted::all>(x, y, groups, stride, twiddle, parts);
    default:
      return run_pass<Real, 5, Zero::none, Wanted::all>(x, y, groups, stride, twiddle, parts);
  }
}

FLOE_SIMD_CLONES
void run(int radix, Zero zero, Wanted wanted, const float* x, float* y, Index groups, Index stride,
         const float* twiddle, Parts parts) {
  run_any(radix, zero, wanted, x, y, groups, stride, twiddle, parts);
}

FLOE_SIMD_CLONES
void run(int radix, Zero zero, Wanted wanted, const double* x, double* y, Index groups,
         Index stride, const double* twiddle, Parts parts) {
  run_any(radix, zero, wanted, x, y, groups, stride, twiddle, parts);
}

}  // namespace

template <class Real>
LaneFft<Real>::LaneFft(Index length) : length_(length) {
  FLOE_EXPECT(length == fast_length(length));
  // The pass that leaves out a half has radix 4: first forward, last backward
  std::vector<int> radices;
  Index rest = length / 4;
  for (const int radix : {5, 3, 4, 2})
    for (; rest % radix == 0; rest /= radix) radices.push_back(radix);
  std::vector<int> forward = {4}, backward = radices;
  forward.insert(forward.end(), radices.begin(), radices.end());
  backward.push_back(4);
  forward_ = make_passes(length, forward);
  backward_ = make_passes(length, backward);
}

template <class Real>
Index LaneFft<Real>::fast_length(Index least) {
  for (Index n = std::max<Index>(4, (least + 3) / 4 * 4);; n += 4) {
    Index rest = n;
    for (const Index factor : {2, 3, 5})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return n;
  }
}

template <class Real>
std::vector<typename LaneFft<Real>::Pass> LaneFft<Real>::make_passes(
    Index length, const std::vector<int>& radices) {
  std::vector<Pass> passes;
  Index left = length;
  for (const int radix : radices) {
    Pass pass{radix, left / radix, length / left, {}};
    for (Index p = 0; p < pass.groups; ++p)
      for (int k = 1; k < radix; ++k) {
        const double angle =
            -2.0 * std::numbers::pi * static_cast<double>(p * k % left) / static_cast<double>(left);
        pass.twiddle.push_back(static_cast<Real>(std::cos(angle)));
        pass.twiddle.push_back(static_cast<Real>(std::sin(angle)));
      }
    left = pass.groups;
    passes.push_back(std::move(pass));
  }
  return passes;
}

template <class Real>
Real* LaneFft<Real>::forward(Real* data, Real* work) const {
  for (const Pass& pass : forward_) {
    run(pass.radix, &pass == &forward_.front() ? Zero::second_half : Zero::none, Wanted::all, data,
        work, pass.groups, pass.stride, pass.twiddle.data(), {0, kLanes<Real>});
    std::swap(data, work);
  }
  return data;
}

template <class Real>
Real* LaneFft<Real>::backward(Real* data, Real* work) const {
  for (const Pass& pass : backward_) {
    run(pass.radix, Zero::none, &pass == &backward_.back() ? Wanted::first_half : Wanted::all, data,
        work, pass.groups, pass.stride, pass.twiddle.data(), {kLanes<Real>, 0});
    std::swap(data, work);
  }
  return data;
}

template class LaneFft<float>;
template class LaneFft<double>;

}  // namespace floe::fmm::pfft
