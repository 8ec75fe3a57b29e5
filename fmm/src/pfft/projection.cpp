#include "pfft/projection.hpp"

#include "pfft/stencil_polynomials.hpp"

#include <floe/numeric/simd.hpp>

#include <algorithm>

namespace floe::fmm::pfft {
namespace {

constexpr Index kBand = 16;  // rows of cells that one thread projects; ≥ the largest stencil

// Points of a row of cells, their stencils' corners and the grid
template <class Real>
struct Task {
  Index begin, end;
  const StencilPolynomials<Real>& polynomials;  // view
  const Real* place;
  const std::int32_t *cell_x, *cell_y;
  Index stride;  // of the grid, from re to im
  Real* grid;
};

template <class Real>
Task<Real> make_task(const Grid& grid, const CellPoints& points, Index row,
                     const StencilPolynomials<Real>& polynomials, const GridData<Real>& values) {
  return {points.cell_begin[row * grid.cells_x()],
          points.cell_begin[(row + 1) * grid.cells_x()],
          polynomials,
          points.places<Real>(),
          points.cell_x.data(),
          points.cell_y.data(),
          values.stride,
          values.row(0)};
}

template <class Real>
inline constexpr int kVectors = AxisWeights<Real>::kVectors;

template <class Real, int kStencil>
FLOE_INLINE void project_all(const Task<Real>& task, const Real* charges_re,
                             const Real* charges_im) {
  constexpr int kV = kVectors<Real>;
  const Task<Real> t = task;  // NOTE: a copy cannot change when the grid does: the compiler knows
  for (Index k = t.begin; k < t.end; ++k) {
    AxisWeights<Real> along_x, along_y;
    t.polynomials.evaluate_of(kStencil, t.place[2 * k], along_x);
    t.polynomials.evaluate_of(kStencil, t.place[2 * k + 1], along_y);
    Real weight_y[kWeights];
    for (int v = 0; v < kV; ++v) store(weight_y + kLanes<Real> * v, along_y.vector[v]);
    Real* to_re = t.grid + (t.cell_x[k] + 2 * t.stride * t.cell_y[k]);
    for (int b = 0; b < kStencil; ++b, to_re += 2 * t.stride) {
      Real* const to_im = to_re + t.stride;
      const Real factor_re = weight_y[b] * charges_re[k], factor_im = weight_y[b] * charges_im[k];
      for (int v = 0; v < kV; ++v) {
        Lanes<Real> re, im;
        load(re, to_re + kLanes<Real> * v);
        load(im, to_im + kLanes<Real> * v);
        store(to_re + kLanes<Real> * v, Lanes<Real>(re + factor_re * along_x.vector[v]));
        store(to_im + kLanes<Real> * v, Lanes<Real>(im + factor_im * along_x.vector[v]));
      }
    }
  }
}

template <class Real, int kStencil>
FLOE_INLINE void interpolate_all(const Task<Real>& task, Real* potentials_re, Real* potentials_im) {
  constexpr int kV = kVectors<Real>;
  const Task<Real> t = task;  // NOTE: a copy cannot change when the grid does: the compiler knows
  for (Index k = t.begin; k < t.end; ++k) {
    AxisWeights<Real> along_x, along_y;
    t.polynomials.evaluate_of(kStencil, t.place[2 * k], along_x);
    t.polynomials.evaluate_of(kStencil, t.place[2 * k + 1], along_y);
    Real weight_y[kWeights];
    for (int v = 0; v < kV; ++v) store(weight_y + kLanes<Real> * v, along_y.vector[v]);
    const Real* from_re = t.grid + (t.cell_x[k] + 2 * t.stride * t.cell_y[k]);
    Lanes<Real> row_re[kV] = {}, row_im[kV] = {};
    for (int b = 0; b < kStencil; ++b, from_re += 2 * t.stride)
      for (int v = 0; v < kV; ++v) {
        Lanes<Real> re, im;
        load(re, from_re + kLanes<Real> * v);
        load(im, from_re + t.stride + kLanes<Real> * v);
        row_re[v] += weight_y[b] * re;
        row_im[v] += weight_y[b] * im;
      }
    Lanes<Real> sum_re = {}, sum_im = {};
    for (int v = 0; v < kV; ++v) {
      sum_re += along_x.vector[v] * row_re[v];
      sum_im += along_x.vector[v] * row_im[v];
    }
    potentials_re[k] = sum_of_lanes(sum_re);
    potentials_im[k] = sum_of_lanes(sum_im);
  }
}

FLOE_SIMD_CLONES void project_points(const Task<float>& task, const float* re, const float* im) {
  for_stencil(
      task.polynomials.stencil(), [&](auto stencil) __attribute__((always_inline)) {
        project_all<float, stencil()>(task, re, im);
      });
}
FLOE_SIMD_CLONES void project_points(const Task<double>& task, const double* re, const double* im) {
  for_stencil(
      task.polynomials.stencil(), [&](auto stencil) __attribute__((always_inline)) {
        project_all<double, stencil()>(task, re, im);
      });
}
FLOE_SIMD_CLONES void interpolate_points(const Task<float>& task, float* re, float* im) {
  for_stencil(
      task.polynomials.stencil(), [&](auto stencil) __attribute__((always_inline)) {
        interpolate_all<float, stencil()>(task, re, im);
      });
}
FLOE_SIMD_CLONES void interpolate_points(const Task<double>& task, double* re, double* im) {
  for_stencil(
      task.polynomials.stencil(), [&](auto stencil) __attribute__((always_inline)) {
        interpolate_all<double, stencil()>(task, re, im);
      });
}

}  // namespace

template <class Real>
void project(const Grid& grid, const CellPoints& points, const Real* charges_re,
             const Real* charges_im, GridData<Real>& values) {
  const StencilPolynomials<Real> polynomials(grid.stencil);
  const Index bands = (grid.cells_y() + kBand - 1) / kBand;
#pragma omp parallel
  {
#pragma omp for schedule(static)
    for (Index j = 0; j < grid.ny; ++j) std::fill_n(values.row(j), 2 * values.stride, Real(0));

    // Even bands reach over into odd ones but not into each other, and the other way round
    for (Index parity = 0; parity < 2; ++parity) {
#pragma omp for schedule(dynamic, 1)
      for (Index band = parity; band < bands; band += 2)
        for (Index row = band * kBand; row < std::min(grid.cells_y(), (band + 1) * kBand); ++row)
          project_points(make_task(grid, points, row, polynomials, values), charges_re, charges_im);
    }
  }
}

template <class Real>
void interpolate(const Grid& grid, const CellPoints& points, const GridData<Real>& values,
                 Real* potentials_re, Real* potentials_im) {
  const StencilPolynomials<Real> polynomials(grid.stencil);
#pragma omp parallel for schedule(dynamic, 1)
  for (Index row = 0; row < grid.cells_y(); ++row)
    interpolate_points(make_task(grid, points, row, polynomials, values), potentials_re,
                       potentials_im);
}

template void project(const Grid&, const CellPoints&, const float*, const float*, GridData<float>&);
template void project(const Grid&, const CellPoints&, const double*, const double*,
                      GridData<double>&);
template void interpolate(const Grid&, const CellPoints&, const GridData<float>&, float*, float*);
template void interpolate(const Grid&, const CellPoints&, const GridData<double>&, double*,
                          double*);

}  // namespace floe::fmm::pfft
