#include "pfft/projection.hpp"

#include <floe/numeric/simd.hpp>

#include <algorithm>

namespace floe::fmm::pfft {
namespace {

constexpr Index kBand = 16;  // rows of cells that one thread projects; ≥ the largest stencil

// Points of a row of cells, their stencils' corners and the grid
template <class Real>
struct Task {
  Index begin, end;
  int stencil;
  Index stride;
  const Real* weight;
  const std::int32_t *cell_x, *cell_y;
  Real *grid_re, *grid_im;
};

template <class Real>
Task<Real> make_task(const Grid& grid, const CellPoints& points, Index row,
                     const GridData<Real>& values) {
  return {points.cell_begin[row * grid.cells_x()],
          points.cell_begin[(row + 1) * grid.cells_x()],
          grid.stencil,
          values.stride,
          points.weights<Real>(0),
          points.cell_x.data(),
          points.cell_y.data(),
          values.re.data(),
          values.im.data()};
}

// The weights along x of a point and zeros fill kWeights numbers
template <class Real>
inline constexpr int kVectors = static_cast<int>(kWeights / kLanes<Real>);

template <class Real>
FLOE_INLINE void project_point(const Task<Real>& task, Index k, const Real* charges_re,
                               const Real* charges_im) {
  constexpr int kV = kVectors<Real>;
  const Real* const along_x = task.weight + 2 * kWeights * k;
  const Real* const along_y = along_x + kWeights;
  Lanes<Real> row_re[kV], row_im[kV];
  for (int v = 0; v < kV; ++v) {
    Lanes<Real> weight;
    load(weight, along_x + kLanes<Real> * v);
    row_re[v] = charges_re[k] * weight;
    row_im[v] = charges_im[k] * weight;
  }
  const Index corner = task.cell_x[k] + task.stride * task.cell_y[k];
  Real *to_re = task.grid_re + corner, *to_im = task.grid_im + corner;
  for (int b = 0; b < task.stencil; ++b, to_re += task.stride, to_im += task.stride)
    for (int v = 0; v < kV; ++v) {
      Lanes<Real> re, im;
      load(re, to_re + kLanes<Real> * v);
      load(im, to_im + kLanes<Real> * v);
      store(to_re + kLanes<Real> * v, Lanes<Real>(re + along_y[b] * row_re[v]));
      store(to_im + kLanes<Real> * v, Lanes<Real>(im + along_y[b] * row_im[v]));
    }
}

// NOTE: neighbours write to the same places, a few numbers apart, and would wait for each other's
// stores; so points of distant parts of the row take turns
template <class Real>
FLOE_INLINE void project_all(const Task<Real>& task, const Real* charges_re,
                             const Real* charges_im) {
  constexpr Index kTurns = 4;
  const Index part = (task.end - task.begin) / kTurns;
  for (Index k = task.begin; k < task.begin + part; ++k)
    for (Index turn = 0; turn < kTurns; ++turn)
      project_point(task, k + turn * part, charges_re, charges_im);
  for (Index k = task.begin + kTurns * part; k < task.end; ++k)
    project_point(task, k, charges_re, charges_im);
}

template <class Real>
FLOE_INLINE void interpolate_all(const Task<Real>& task, Real* potentials_re, Real* potentials_im) {
  constexpr int kV = kVectors<Real>;
  for (Index k = task.begin; k < task.end; ++k) {
    const Real* const along_x = task.weight + 2 * kWeights * k;
    const Real* const along_y = along_x + kWeights;
    const Index corner = task.cell_x[k] + task.stride * task.cell_y[k];
    const Real *from_re = task.grid_re + corner, *from_im = task.grid_im + corner;
    Lanes<Real> row_re[kV] = {}, row_im[kV] = {};
    for (int b = 0; b < task.stencil; ++b, from_re += task.stride, from_im += task.stride)
      for (int v = 0; v < kV; ++v) {
        Lanes<Real> re, im;
        load(re, from_re + kLanes<Real> * v);
        load(im, from_im + kLanes<Real> * v);
        row_re[v] += along_y[b] * re;
        row_im[v] += along_y[b] * im;
      }
    Lanes<Real> sum_re = {}, sum_im = {};
    for (int v = 0; v < kV; ++v) {
      Lanes<Real> weight;
      load(weight, along_x + kLanes<Real> * v);
      sum_re += weight * row_re[v];
      sum_im += weight * row_im[v];
    }
    potentials_re[k] = sum_of_lanes(sum_re);
    potentials_im[k] = sum_of_lanes(sum_im);
  }
}

FLOE_SIMD_CLONES void project_points(const Task<float>& task, const float* re, const float* im) {
  project_all(task, re, im);
}
FLOE_SIMD_CLONES void project_points(const Task<double>& task, const double* re, const double* im) {
  project_all(task, re, im);
}
FLOE_SIMD_CLONES void interpolate_points(const Task<float>& task, float* re, float* im) {
  interpolate_all(task, re, im);
}
FLOE_SIMD_CLONES void interpolate_points(const Task<double>& task, double* re, double* im) {
  interpolate_all(task, re, im);
}

}  // namespace

template <class Real>
void project(const Grid& grid, const CellPoints& points, const Real* charges_re,
             const Real* charges_im, GridData<Real>& values) {
  const Index bands = (grid.cells_y() + kBand - 1) / kBand;
#pragma omp parallel
  {
#pragma omp for schedule(static)
    for (Index j = 0; j < grid.ny; ++j) {
      std::fill_n(values.re.data() + values.stride * j, values.stride, Real(0));
      std::fill_n(values.im.data() + values.stride * j, values.stride, Real(0));
    }

    // Even bands reach over into odd ones but not into each other, and the other way round
    for (Index parity = 0; parity < 2; ++parity) {
#pragma omp for schedule(dynamic, 1)
      for (Index band = parity; band < bands; band += 2)
        for (Index row = band * kBand; row < std::min(grid.cells_y(), (band + 1) * kBand); ++row)
          project_points(make_task(grid, points, row, values), charges_re, charges_im);
    }
  }
}

template <class Real>
void interpolate(const Grid& grid, const CellPoints& points, const GridData<Real>& values,
                 Real* potentials_re, Real* potentials_im) {
#pragma omp parallel for schedule(dynamic, 1)
  for (Index row = 0; row < grid.cells_y(); ++row)
    interpolate_points(make_task(grid, points, row, values), potentials_re, potentials_im);
}

template void project(const Grid&, const CellPoints&, const float*, const float*, GridData<float>&);
template void project(const Grid&, const CellPoints&, const double*, const double*,
                      GridData<double>&);
template void interpolate(const Grid&, const CellPoints&, const GridData<float>&, float*, float*);
template void interpolate(const Grid&, const CellPoints&, const GridData<double>&, double*,
                          double*);

}  // namespace floe::fmm::pfft
