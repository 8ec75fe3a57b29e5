#include "pfft/near_part.hpp"

#include <floe/numeric/simd.hpp>

#include <algorithm>

namespace floe::fmm::pfft {
namespace {

// A range of near sources: its first sorted number and its blocks of kLanes
struct Range {
  Index begin, blocks;
};

// Near ranges of a cell
template <class Visit>
void collect_ranges(const Geometry& geometry, Index cell, std::vector<Range>& ranges,
                    const Visit& visit) {
  ranges.clear();
  for_near_ranges(geometry.grid, geometry.near, geometry.sources.cell_begin,
                  cell % geometry.grid.cells_x(), cell / geometry.grid.cells_x(),
                  [&](Index begin, Index end) {
                    ranges.push_back({begin, padded_range(end - begin) / kLanes});
                    visit(begin, end);
                  });
}

// One row times one column in kLanes partial sums: the order is the same in every instruction set
template <class Real>
inline Complex row_times(const Real* value, const Range* ranges, Index range_count,
                         const double* charge_re, const double* charge_im) {
  double sum_re[kLanes] = {}, sum_im[kLanes] = {};
  for (Index r = 0; r < range_count; ++r) {
    const double* const re = charge_re + ranges[r].begin;
    const double* const im = charge_im + ranges[r].begin;
    for (Index k = 0; k < ranges[r].blocks * kLanes; k += kLanes, value += 2 * kLanes)
      for (Index l = 0; l < kLanes; ++l) {
        const double a = value[l], b = value[kLanes + l];
        sum_re[l] += a * re[k + l];
        sum_im[l] += a * im[k + l];
        sum_re[l] -= b * im[k + l];
        sum_im[l] += b * re[k + l];
      }
  }
  return {(sum_re[0] + sum_re[1]) + (sum_re[2] + sum_re[3]),
          (sum_im[0] + sum_im[1]) + (sum_im[2] + sum_im[3])};
}

// Rows of a cell's targets times all columns; sums[row·columns + column]
template <class Real>
inline void rows_times(const Real* value, Index row_length, Index rows, const Range* ranges,
                       Index range_count, const double* charges, Index column_length, Index columns,
                       Complex* sums) {
  for (Index t = 0; t < rows; ++t, value += 2 * row_length)
    for (Index c = 0; c < columns; ++c) {
      const double* const re = charges + 2 * column_length * c;
      *sums++ = row_times(value, ranges, range_count, re, re + column_length);
    }
}

FLOE_SIMD_CLONES
void multiply_rows(const float* value, Index row_length, Index rows, const Range* ranges,
                   Index range_count, const double* charges, Index column_length, Index columns,
                   Complex* sums) {
  rows_times(value, row_length, rows, ranges, range_count, charges, column_length, columns, sums);
}

FLOE_SIMD_CLONES
void multiply_rows(const double* value, Index row_length, Index rows, const Range* ranges,
                   Index range_count, const double* charges, Index column_length, Index columns,
                   Complex* sums) {
  rows_times(value, row_length, rows, ranges, range_count, charges, column_length, columns, sums);
}

// Charges in the order of the cells, real and imaginary parts apart; kLanes zeros behind each
std::vector<double> sorted_charges(const CellPoints& sources,
                                   const Eigen::Ref<const MatXcd>& charges) {
  const Index length = sources.count() + kLanes;
  std::vector<double> sorted(static_cast<std::size_t>(2 * length * charges.cols()));
#pragma omp parallel for schedule(static)
  for (Index s = 0; s < sources.count(); ++s)
    for (Index c = 0; c < charges.cols(); ++c) {
      const Complex charge = charges(sources.original[s], c);
      sorted[static_cast<std::size_t>(2 * length * c + s)] = charge.real();
      sorted[static_cast<std::size_t>(2 * length * c + length + s)] = charge.imag();
    }
  return sorted;
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
    std::vector<Range> ranges;
    std::vector<double> distance;
    std::vector<std::size_t> place;
    std::vector<Complex> near, exact;
#pragma omp for schedule(dynamic, 1)
    for (Index row = 0; row < grid.cells_y(); ++row)
      for (Index cell = row * grid.cells_x(); cell < (row + 1) * grid.cells_x(); ++cell)
        for (Index t = targets.cell_begin[cell]; t < targets.cell_begin[cell + 1]; ++t) {
          // Distances and, negative, the grid's values of the near pairs of target t
          distance.clear();
          place.clear();
          near.clear();
          box.fill(t);
          Index block = geometry.near_begin[cell] / kLanes +
                        (t - targets.cell_begin[cell]) * geometry.near_length[cell] / kLanes;
          collect_ranges(geometry, cell, ranges, [&](Index begin, Index end) {
            for (Index s = begin; s < end; ++s) {
              const Index k = s - begin;
              near.push_back(-box.value(s));
              distance.push_back((sources.position.col(s) - targets.position.col(t)).norm());
              place.push_back(
                  static_cast<std::size_t>(2 * kLanes * (block + k / kLanes) + k % kLanes));
            }
            block += padded_range(end - begin) / kLanes;
          });

          // Add the kernel; coincident points have none
          std::vector<double> positive = distance;
          for (double& r : positive) r = r > 0.0 ? r : grid.spacing;
          exact.resize(distance.size());
          kernel.evaluate(positive, exact);
          for (std::size_t k = 0; k < near.size(); ++k) {
            if (distance[k] > 0.0) near[k] += exact[k];
            value_[place[k]] = static_cast<Real>(near[k].real());
            value_[place[k] + kLanes] = static_cast<Real>(near[k].imag());
          }
        }
  }
}

template <class Real>
void NearPart<Real>::multiply_add(const Geometry& geometry, const Eigen::Ref<const MatXcd>& charges,
                                  Eigen::Ref<MatXcd> potentials) const {
  const Grid& grid = geometry.grid;
  const CellPoints &sources = geometry.sources, &targets = geometry.targets;
  const std::vector<double> sorted = sorted_charges(sources, charges);
  const Index columns = charges.cols();
#pragma omp parallel
  {
    std::vector<Range> ranges;
    std::vector<Complex> sums;
#pragma omp for schedule(dynamic, 1)
    for (Index row = 0; row < grid.cells_y(); ++row)
      for (Index cell = row * grid.cells_x(); cell < (row + 1) * grid.cells_x(); ++cell) {
        const Index first = targets.cell_begin[cell], rows = targets.cell_begin[cell + 1] - first;
        if (rows == 0) continue;
        collect_ranges(geometry, cell, ranges, [](Index, Index) {});
        sums.resize(static_cast<std::size_t>(rows * columns));
        multiply_rows(value_.data() + 2 * geometry.near_begin[cell], geometry.near_length[cell],
                      rows, ranges.data(), static_cast<Index>(ranges.size()), sorted.data(),
                      sources.count() + kLanes, columns, sums.data());
        for (Index t = 0; t < rows; ++t)
          for (Index c = 0; c < columns; ++c)
            potentials(targets.original[first + t], c) += sums[t * columns + c];
      }
  }
}

template class NearPart<float>;
template class NearPart<double>;

}  // namespace floe::fmm::pfft
