#include "pfft/projection.hpp"

#include <floe/numeric/simd.hpp>

#include <algorithm>

namespace floe::fmm::pfft {
namespace {

constexpr Index kBand = 16;  // rows of cells that one thread projects; ≥ the largest stencil

struct Range {
  Index begin, end;
};

template <int W>
inline void project_points(const CellPoints& points, Range range, Index nx, const double* charges,
                           double* values) {
  for (Index k = range.begin; k < range.end; ++k) {
    const double* const wx = points.weights_x(k, W);
    const double* const wy = points.weights_y(k, W);
    const Index i = points.original[k];
    const double re = charges[2 * i], im = charges[2 * i + 1];
    double row[2 * W];
    for (int a = 0; a < W; ++a) {
      row[2 * a] = wx[a] * re;
      row[2 * a + 1] = wx[a] * im;
    }
    double* const corner = values + 2 * (points.cell_x[k] + nx * points.cell_y[k]);
    for (int b = 0; b < W; ++b) {
      double* const to = corner + 2 * nx * b;
      for (int a = 0; a < 2 * W; ++a) to[a] += wy[b] * row[a];
    }
  }
}

template <int W>
inline void interpolate_points(const CellPoints& points, Range range, Index nx,
                               const double* values, double* potentials) {
  for (Index k = range.begin; k < range.end; ++k) {
    const double* const wx = points.weights_x(k, W);
    const double* const wy = points.weights_y(k, W);
    const double* const corner = values + 2 * (points.cell_x[k] + nx * points.cell_y[k]);
    double row[2 * W] = {};
    for (int b = 0; b < W; ++b) {
      const double* const from = corner + 2 * nx * b;
      for (int a = 0; a < 2 * W; ++a) row[a] += wy[b] * from[a];
    }
    double re = 0.0, im = 0.0;
    for (int a = 0; a < W; ++a) {
      re += wx[a] * row[2 * a];
      im += wx[a] * row[2 * a + 1];
    }
    const Index i = points.original[k];
    potentials[2 * i] = re;
    potentials[2 * i + 1] = im;
  }
}

#define FLOE_FOR_STENCIL(function, ...) \
  switch (stencil) {                    \
    case 2:                             \
      return function<2>(__VA_ARGS__);  \
    case 3:                             \
      return function<3>(__VA_ARGS__);  \
    case 4:                             \
      return function<4>(__VA_ARGS__);  \
    case 5:                             \
      return function<5>(__VA_ARGS__);  \
    case 6:                             \
      return function<6>(__VA_ARGS__);  \
    case 7:                             \
      return function<7>(__VA_ARGS__);  \
    case 8:                             \
      return function<8>(__VA_ARGS__);  \
    case 9:                             \
      return function<9>(__VA_ARGS__);  \
    default:                            \
      return function<10>(__VA_ARGS__); \
  }

FLOE_SIMD_CLONES
void project_range(int stencil, const CellPoints& points, Range range, Index nx,
                   const double* charges, double* values){
    FLOE_FOR_STENCIL(project_points, points, range, nx, charges, values)}

FLOE_SIMD_CLONES void interpolate_range(int stencil, const CellPoints& points, Range range,
                                        Index nx, const double* values, double* potentials) {
  FLOE_FOR_STENCIL(interpolate_points, points, range, nx, values, potentials)
}

}  // namespace

void project(const Grid& grid, const CellPoints& points, const Complex* charges, Complex* values) {
  const auto* const in = reinterpret_cast<const double*>(charges);
  auto* const out = reinterpret_cast<double*>(values);
  const Index bands = (grid.cells_y() + kBand - 1) / kBand;
#pragma omp parallel
  {
#pragma omp for schedule(static)
    for (Index j = 0; j < grid.ny; ++j)
      std::fill_n(values + grid.nx * j, grid.nx, Complex(0.0, 0.0));

    // Even bands reach over into odd ones but not into each other, and the other way round
    for (Index parity = 0; parity < 2; ++parity) {
#pragma omp for schedule(dynamic, 1)
      for (Index band = parity; band < bands; band += 2) {
        const Index last = std::min(grid.cells_y(), (band + 1) * kBand);
        const Range range{points.cell_begin[band * kBand * grid.cells_x()],
                          points.cell_begin[last * grid.cells_x()]};
        project_range(grid.stencil, points, range, grid.nx, in, out);
      }
    }
  }
}

void interpolate(const Grid& grid, const CellPoints& points, const Complex* values,
                 Complex* potentials) {
  const auto* const in = reinterpret_cast<const double*>(values);
  auto* const out = reinterpret_cast<double*>(potentials);
#pragma omp parallel for schedule(dynamic, 1)
  for (Index row = 0; row < grid.cells_y(); ++row) {
    const Range range{points.cell_begin[row * grid.cells_x()],
                      points.cell_begin[(row + 1) * grid.cells_x()]};
    interpolate_range(grid.stencil, points, range, grid.nx, in, out);
  }
}

}  // namespace floe::fmm::pfft
