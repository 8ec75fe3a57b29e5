#pragma once

#include <floe/numeric/types.hpp>

/// The inner loops: products of real matrices with one complex column, kept as a real and an
/// imaginary one. Each output is one sum in a fixed order, whatever else is computed beside it.
namespace floe::fmm::multipole {

/// Lengths that the loops below walk in: 32 bytes.
template <class Real>
constexpr Index padded(Index count) {
  constexpr Index kLane = 32 / static_cast<Index>(sizeof(Real));
  return (count + kLane - 1) / kLane * kLane;
}

/// Vectors multiplied at once by multiply_add.
constexpr int kTile = 4;

/// y_b += M x_b for four complex vectors: real part first, imaginary part `rows` (for y) or
/// `x_stride` (for x) later. M is column by column, `rows` (padded) by `columns` (no zeros,
/// please).
void multiply_add(const float* matrix, Index rows, Index columns, Index x_stride,
                  const float* const* x, float* const* y);
void multiply_add(const double* matrix, Index rows, Index columns, Index x_stride,
                  const double* const* x, double* const* y);

/// y += Σ_j row_j x_j: `count` rows of `length` padded numbers; y as above.
void spread_rows(const float* rows, Index count, Index length, const float* x_real,
                 const float* x_imag, float* y);
void spread_rows(const double* rows, Index count, Index length, const double* x_real,
                 const double* x_imag, double* y);

/// y_i += row_i · x: `count` rows of `length` padded numbers.
void row_products(const float* rows, Index count, Index length, const float* x_real,
                  const float* x_imag, float* y_real, float* y_imag);
void row_products(const double* rows, Index count, Index length, const double* x_real,
                  const double* x_imag, double* y_real, double* y_imag);

}  // namespace floe::fmm::multipole
