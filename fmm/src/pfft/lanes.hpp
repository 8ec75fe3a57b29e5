#pragma once

#include <floe/numeric/types.hpp>

#include <cstdint>

#define FLOE_INLINE inline __attribute__((always_inline))

/// Vectors of 32 bytes, whatever the instruction set: the order of all sums is the same in each.
namespace floe::fmm::pfft {

template <class Real>
inline constexpr Index kLanes = 32 / static_cast<Index>(sizeof(Real));

template <class Real>
struct LaneVector {
  using Type __attribute__((vector_size(32))) = Real;
};
template <class Real>
using Lanes = typename LaneVector<Real>::Type;

template <class Real>
FLOE_INLINE void load(Lanes<Real>& v, const Real* from) {
  __builtin_memcpy(&v, from, sizeof(v));
}

template <class Real>
FLOE_INLINE void store(Real* to, const Lanes<Real>& v) {
  __builtin_memcpy(to, &v, sizeof(v));
}

FLOE_INLINE float sum_of_lanes(const Lanes<float>& lanes) {
  using Mask __attribute__((vector_size(32))) = std::int32_t;
  Lanes<float> v = lanes;
  v += __builtin_shuffle(v, Mask{4, 5, 6, 7, 0, 1, 2, 3});
  v += __builtin_shuffle(v, Mask{2, 3, 0, 1, 6, 7, 4, 5});
  return v[0] + v[1];
}
FLOE_INLINE double sum_of_lanes(const Lanes<double>& lanes) {
  using Mask __attribute__((vector_size(32))) = std::int64_t;
  Lanes<double> v = lanes;
  v += __builtin_shuffle(v, Mask{2, 3, 0, 1});
  return v[0] + v[1];
}

/// Length filled up to whole vectors.
template <class Real>
constexpr Index whole_lanes(Index count) {
  return (count + kLanes<Real> - 1) / kLanes<Real> * kLanes<Real>;
}

/// v[i] lane j becomes v[j] lane i. Shuffles within halves first, then of halves.
FLOE_INLINE void transpose(Lanes<float>* v) {
  using Mask __attribute__((vector_size(32))) = std::int32_t;
  constexpr Mask kLow = {0, 8, 1, 9, 4, 12, 5, 13}, kHigh = {2, 10, 3, 11, 6, 14, 7, 15};
  constexpr Mask kLowPair = {0, 1, 8, 9, 4, 5, 12, 13}, kHighPair = {2, 3, 10, 11, 6, 7, 14, 15};
  constexpr Mask kLowHalf = {0, 1, 2, 3, 8, 9, 10, 11}, kHighHalf = {4, 5, 6, 7, 12, 13, 14, 15};
  Lanes<float> a[8], b[8];
  for (int i = 0; i < 8; i += 2) {
    a[i] = __builtin_shuffle(v[i], v[i + 1], kLow);
    a[i + 1] = __builtin_shuffle(v[i], v[i + 1], kHigh);
  }
  for (int i = 0; i < 8; i += 4)
    for (int k = 0; k < 2; ++k) {
      b[i + 2 * k] = __builtin_shuffle(a[i + k], a[i + k + 2], kLowPair);
      b[i + 2 * k + 1] = __builtin_shuffle(a[i + k], a[i + k + 2], kHighPair);
    }
  for (int i = 0; i < 4; ++i) {
    v[i] = __builtin_shuffle(b[i], b[i + 4], kLowHalf);
    v[i + 4] = __builtin_shuffle(b[i], b[i + 4], kHighHalf);
  }
}

FLOE_INLINE void transpose(Lanes<double>* v) {
  using Mask __attribute__((vector_size(32))) = std::int64_t;
  constexpr Mask kLow = {0, 4, 2, 6}, kHigh = {1, 5, 3, 7};
  constexpr Mask kLowHalf = {0, 1, 4, 5}, kHighHalf = {2, 3, 6, 7};
  Lanes<double> a[4];
  for (int i = 0; i < 4; i += 2) {
    a[i] = __builtin_shuffle(v[i], v[i + 1], kLow);
    a[i + 1] = __builtin_shuffle(v[i], v[i + 1], kHigh);
  }
  for (int i = 0; i < 2; ++i) {
    v[i] = __builtin_shuffle(a[i], a[i + 2], kLowHalf);
    v[i + 2] = __builtin_shuffle(a[i], a[i + 2], kHighHalf);
  }
}

}  // namespace floe::fmm::pfft
