#include "multipole/products.hpp"

#include <floe/numeric/simd.hpp>

#define FLOE_INLINE inline __attribute__((always_inline))

namespace floe::fmm::multipole {
namespace {

template <class Real, int kBytes>
struct Lanes {
  using Type __attribute__((vector_size(kBytes))) = Real;
};
template <class Real, int kBytes>
using Vector = typename Lanes<Real, kBytes>::Type;

template <class V, class Real>
FLOE_INLINE void load(V& v, const Real* from) {
  __builtin_memcpy(&v, from, sizeof(v));
}

template <class V, class Real>
FLOE_INLINE void add_to(Real* to, const V& v) {
  V sum;
  load(sum, to);
  sum += v;
  __builtin_memcpy(to, &sum, sizeof(sum));
}

template <class Real, int kBytes>
FLOE_INLINE Real lane_sum(const Vector<Real, kBytes>& v) {
  Real lane[kBytes / sizeof(Real)];
  __builtin_memcpy(lane, &v, sizeof(v));
  for (int width = static_cast<int>(kBytes / sizeof(Real)) / 2; width > 0; width /= 2)
    for (int l = 0; l < width; ++l) lane[l] += lane[l + width];
  return lane[0];
}

// One strip of rows of y += M x for four complex vectors
template <class Real, int kBytes>
FLOE_INLINE void multiply_strip(const Real* matrix, Index rows, Index columns, Index x_stride,
                                const Real* const* x, Real* const* y, Index first) {
  using V = Vector<Real, kBytes>;
  V real[kTile] = {}, imag[kTile] = {};
  const Real *x0 = x[0], *x1 = x[1], *x2 = x[2], *x3 = x[3];
  for (Index j = 0; j < columns; ++j) {
    V m;
    load(m, matrix + j * rows + first);
    real[0] += m * x0[j];
    imag[0] += m * x0[j + x_stride];
    real[1] += m * x1[j];
    imag[1] += m * x1[j + x_stride];
    real[2] += m * x2[j];
    imag[2] += m * x2[j + x_stride];
    real[3] += m * x3[j];
    imag[3] += m * x3[j + x_stride];
  }
  for (int b = 0; b < kTile; ++b) {
    add_to(y[b] + first, real[b]);
    add_to(y[b] + rows + first, imag[b]);
  }
}

template <class Real>
FLOE_INLINE void multiply_all_strips(const Real* matrix, Index rows, Index columns, Index x_stride,
                                     const Real* const* x, Real* const* y, bool wide) {
  constexpr Index kWide = 64 / sizeof(Real), kNarrow = kWide / 2;
  Index first = 0;
  for (; wide && first + kWide <= rows; first += kWide)
    multiply_strip<Real, 64>(matrix, rows, columns, x_stride, x, y, first);
  for (; first < rows; first += kNarrow)
    multiply_strip<Real, 32>(matrix, rows, columns, x_stride, x, y, first);
}

template <class Real, int kBytes>
FLOE_INLINE void spread_strip(const Real* rows, Index count, Index length, const Real* x_real,
                              const Real* x_imag, Real* y, Index first) {
  using V = Vector<Real, kBytes>;
  V real[2] = {}, imag[2] = {};
  Index j = 0;
  for (; j + 2 <= count; j += 2)
    for (int u = 0; u < 2; ++u) {
      V row;
      load(row, rows + (j + u) * length + first);
      real[u] += row * x_real[j + u];
      imag[u] += row * x_imag[j + u];
    }
  if (j < count) {
    V row;
    load(row, rows + j * length + first);
    real[0] += row * x_real[j];
    imag[0] += row * x_imag[j];
  }
  add_to(y + first, real[0] + real[1]);
  add_to(y + length + first, imag[0] + imag[1]);
}

template <class Real>
FLOE_INLINE void spread_all_rows(const Real* rows, Index count, Index length, const Real* x_real,
                                 const Real* x_imag, Real* y) {
  constexpr Index kWide = 64 / sizeof(Real);
  Index first = 0;
  for (; first + kWide <= length; first += kWide)
    spread_strip<Real, 64>(rows, count, length, x_real, x_imag, y, first);
  if (first < length) spread_strip<Real, 32>(rows, count, length, x_real, x_imag, y, first);
}

template <class Real>
FLOE_INLINE void all_row_products(const Real* rows, Index count, Index length, const Real* x_real,
                                  const Real* x_imag, Real* y_real, Real* y_imag) {
  constexpr Index kLane = 32 / sizeof(Real);
  using V = Vector<Real, 32>;
  for (Index i = 0; i < count; ++i) {
    const Real* row = rows + i * length;
    V real[2] = {}, imag[2] = {};
    Index j = 0;
    for (; j + 2 * kLane <= length; j += 2 * kLane)
      for (Index u = 0; u < 2; ++u) {
        V r, x, y;
        load(r, row + j + u * kLane);
        load(x, x_real + j + u * kLane);
        load(y, x_imag + j + u * kLane);
        real[u] += r * x;
        imag[u] += r * y;
      }
    if (j < length) {
      V r, x, y;
      load(r, row + j);
      load(x, x_real + j);
      load(y, x_imag + j);
      real[0] += r * x;
      imag[0] += r * y;
    }
    y_real[i] += lane_sum<Real, 32>(real[0] + real[1]);
    y_imag[i] += lane_sum<Real, 32>(imag[0] + imag[1]);
  }
}

FLOE_SIMD_CLONES void multiply_strips(const float* matrix, Index rows, Index columns,
                                      Index x_stride, const float* const* x, float* const* y,
                                      bool wide) {
  multiply_all_strips(matrix, rows, columns, x_stride, x, y, wide);
}

FLOE_SIMD_CLONES void multiply_strips(const double* matrix, Index rows, Index columns,
                                      Index x_stride, const double* const* x, double* const* y,
                                      bool wide) {
  multiply_all_strips(matrix, rows, columns, x_stride, x, y, wide);
}

}  // namespace

void multiply_add(const float* matrix, Index rows, Index columns, Index x_stride,
                  const float* const* x, float* const* y) {
  multiply_strips(matrix, rows, columns, x_stride, x, y, numeric::has_wide_vectors());
}

void multiply_add(const double* matrix, Index rows, Index columns, Index x_stride,
                  const double* const* x, double* const* y) {
  multiply_strips(matrix, rows, columns, x_stride, x, y, numeric::has_wide_vectors());
}

FLOE_SIMD_CLONES void spread_rows(const float* rows, Index count, Index length, const float* x_real,
                                  const float* x_imag, float* y) {
  spread_all_rows(rows, count, length, x_real, x_imag, y);
}

FLOE_SIMD_CLONES void spread_rows(const double* rows, Index count, Index length,
                                  const double* x_real, const double* x_imag, double* y) {
  spread_all_rows(rows, count, length, x_real, x_imag, y);
}

FLOE_SIMD_CLONES void row_products(const float* rows, Index count, Index length,
                                   const float* x_real, const float* x_imag, float* y_real,
                                   float* y_imag) {
  all_row_products(rows, count, length, x_real, x_imag, y_real, y_imag);
}

FLOE_SIMD_CLONES void row_products(const double* rows, Index count, Index length,
                                   const double* x_real, const double* x_imag, double* y_real,
                                   double* y_imag) {
  all_row_products(rows, count, length, x_real, x_imag, y_real, y_imag);
}

}  // namespace floe::fmm::multipole
