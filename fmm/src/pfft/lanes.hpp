#pragma once

#include <floe/numeric/types.hpp>

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

/// The sum in pairs, the same in each instruction set.
FLOE_INLINE float sum_of_lanes(const Lanes<float>& lanes) {
  Lanes<float> v = lanes;
  v += __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3);
  v += __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5);
  return v[0] + v[1];
}
FLOE_INLINE double sum_of_lanes(const Lanes<double>& lanes) {
  Lanes<double> v = lanes;
  v += __builtin_shufflevector(v, v, 2, 3, 0, 1);
  return v[0] + v[1];
}

/// Length filled up to whole vectors.
template <class Real>
constexpr Index whole_lanes(Index count) {
  return (count + kLanes<Real> - 1) / kLanes<Real> * kLanes<Real>;
}

/// v[i] lane j becomes v[j] lane i. Shuffles within halves first, then of halves.
FLOE_INLINE void transpose(Lanes<float>* v) {
  Lanes<float> a[8], b[8];
  for (int i = 0; i < 8; i += 2) {
    a[i] = __builtin_shufflevector(v[i], v[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    a[i + 1] = __builtin_shufflevector(v[i], v[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  for (int i = 0; i < 8; i += 4)
    for (int k = 0; k < 2; ++k) {
      const Lanes<float>&low = a[i + k], &high = a[i + k + 2];
      b[i + 2 * k] = __builtin_shufflevector(low, high, 0, 1, 8, 9, 4, 5, 12, 13);
      b[i + 2 * k + 1] = __builtin_shufflevector(low, high, 2, 3, 10, 11, 6, 7, 14, 15);
    }
  for (int i = 0; i < 4; ++i) {
    v[i] = __builtin_shufflevector(b[i], b[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    v[i + 4] = __builtin_shufflevector(b[i], b[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

FLOE_INLINE void transpose(Lanes<double>* v) {
  Lanes<double> a[4];
  for (int i = 0; i < 4; i += 2) {
    a[i] = __builtin_shufflevector(v[i], v[i + 1], 0, 4, 2, 6);
    a[i + 1] = __builtin_shufflevector(v[i], v[i + 1], 1, 5, 3, 7);
  }
  for (int i = 0; i < 2; ++i) {
    v[i] = __builtin_shufflevector(a[i], a[i + 2], 0, 1, 4, 5);
    v[i + 2] = __builtin_shufflevector(a[i], a[i + 2], 2, 3, 6, 7);
  }
}

}  // namespace floe::fmm::pfft
