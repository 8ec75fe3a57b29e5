#include "pfft/near_part.hpp"

#include <floe/numeric/simd.hpp>

#include <algorithm>

namespace floe::fmm::pfft {
namespace {

// One row times one column in kLanes partial sums: the order is the same in every instruction set
template <class Real>
inline Complex row_times(const Real* re, const Real* im, const double* x_re, const double* x_im,
                         Index count) {
  double sum_re[kLanes] = {}, sum_im[kLanes] = {};
  for (Index k = 0; k < count; k += kLanes)
    for (Index l = 0; l < kLanes; ++l) {
      const double a = re[k + l], b = im[k + l];
      sum_re[l] += a * x_re[k + l];
      sum_im[l] += a * x_im[k + l];
      sum_re[l] -= b * x_im[k + l];
      sum_im[l] += b * x_re[k + l];
    }
  return {(sum_re[0] + sum_re[1]) + (sum_re[2] + sum_re[3]),
          (sum_im[0] + sum_im[1]) + (sum_im[2] + sum_im[3])};
}

FLOE_SIMD_CLONES
Complex multiply_row(const float* value, Index count, const double* x) {
  return row_times(value, value + count, x, x + count, count);
}

FLOE_SIMD_CLONES
Complex multiply_row(const double* value, Index count, const double* x) {
  return row_times(value, value + count, x, x + count, count);
}

}  // namespace

template <class Real>
NearPart<Real>::NearPart(const Geometry& geometry, const Precorrection& grid_values,
                         const RadialKernel& kernel)
    : value_(static_cast<std::size_t>(2 * geometry.near_begin.back())) {
  const Grid& grid = geometry.grid;
  const CellPoints &sources = geometry.sources, &targets = geometry.targets;
#pragma omp parallel
  {
    Precorrection::Box box(grid_values);
    std::vector<double> distance;
    std::vector<Complex> far, exact;
#pragma omp for schedule(dynamic, 1)
    for (Index row = 0; row < grid.cells_y(); ++row)
      for (Index cell = row * grid.cells_x(); cell < (row + 1) * grid.cells_x(); ++cell)
        for (Index t = targets.cell_begin[cell]; t < targets.cell_begin[cell + 1]; ++t) {
          // Distances and the grid's values of the near pairs of target t
          distance.clear();
          far.clear();
          box.fill(t);
          for_near_ranges(
              grid, geometry.near, sources.cell_begin, cell % grid.cells_x(), row,
              [&](Index begin, Index end) {
                for (Index s = begin; s < end; ++s) {
                  far.push_back(box.value(s));
                  distance.push_back((sources.position.col(s) - targets.position.col(t)).norm());
                }
              });

          // The kernel minus these; coincident points have no kernel
          const std::vector<double> true_distance = distance;
          for (double& r : distance) r = r > 0.0 ? r : grid.spacing;
          exact.resize(distance.size());
          kernel.evaluate(distance, exact);
          const Index padded = padded_row(geometry.near_count[cell]);
          Real* const value = value_.data() + 2 * (geometry.near_begin[cell] +
                                                   (t - targets.cell_begin[cell]) * padded);
          for (std::size_t k = 0; k < far.size(); ++k) {
            const Complex near = (true_distance[k] > 0.0 ? exact[k] : Complex(0.0)) - far[k];
            value[k] = static_cast<Real>(near.real());
            value[static_cast<std::size_t>(padded) + k] = static_cast<Real>(near.imag());
          }
        }
  }
}

template <class Real>
void NearPart<Real>::multiply_add(const Geometry& geometry, const Eigen::Ref<const MatXcd>& charges,
                                  Eigen::Ref<MatXcd> potentials) const {
  const Grid& grid = geometry.grid;
  const CellPoints &sources = geometry.sources, &targets = geometry.targets;
#pragma omp parallel
  {
    std::vector<double> x;  // charges near a cell: real parts, imaginary parts, of each column
#pragma omp for schedule(dynamic, 1)
    for (Index row = 0; row < grid.cells_y(); ++row)
      for (Index cell = row * grid.cells_x(); cell < (row + 1) * grid.cells_x(); ++cell) {
        const Index first = targets.cell_begin[cell], last = targets.cell_begin[cell + 1];
        if (first == last) continue;
        const Index padded = padded_row(geometry.near_count[cell]);
        x.assign(static_cast<std::size_t>(2 * padded * charges.cols()), 0.0);
        Index k = 0;
        for_near_ranges(grid, geometry.near, sources.cell_begin, cell % grid.cells_x(), row,
                        [&](Index begin, Index end) {
                          for (Index s = begin; s < end; ++s, ++k)
                            for (Index c = 0; c < charges.cols(); ++c) {
                              const Complex charge = charges(sources.original[s], c);
                              x[2 * padded * c + k] = charge.real();
                              x[2 * padded * c + padded + k] = charge.imag();
                            }
                        });
        for (Index t = first; t < last; ++t)
          for (Index c = 0; c < charges.cols(); ++c)
            potentials(targets.original[t], c) +=
                multiply_row(value_.data() + 2 * (geometry.near_begin[cell] + (t - first) * padded),
                             padded, x.data() + 2 * padded * c);
      }
  }
}

template class NearPart<float>;
template class NearPart<double>;

}  // namespace floe::fmm::pfft
