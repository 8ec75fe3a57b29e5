#include "pfft/near_part.hpp"

#include <floe/numeric/simd.hpp>

#include <algorithm>

namespace floe::fmm::pfft {
namespace {

constexpr Index kTile = 4;  // columns that are multiplied at once

// Rows of a cell, their potentials and the charges of one column, or of kTile columns as one
// number after the other: real parts, imaginary parts, next source
template <class Real>
struct RowBlock {
  const Real* value;
  Index rows;
  const std::int32_t* start;
  Index vectors;
  const Real* charges;
  Index charge_stride;  // of one column, from re to im
  Real* potentials;
  Index potential_stride;  // from re to im, and from im to the next column
};

// A column's sum has kLanes parts; source k of a range belongs to part k mod kLanes
template <class Real>
FLOE_INLINE void multiply_column(const RowBlock<Real>& block) {
  const Real* value = block.value;
  for (Index row = 0; row < block.rows; ++row) {
    Lanes<Real> sum_re = {}, sum_im = {};
    for (Index b = 0; b < block.vectors; ++b, value += kLanes<Real>) {
      const Real* const q = block.charges + block.start[b];
      Lanes<Real> v, re, im;
      load(v, value);
      load(re, q);
      load(im, q + block.charge_stride);
      sum_re += v * re;
      sum_im += v * im;
    }
    block.potentials[row] += sum_of_lanes(sum_re);
    block.potentials[row + block.potential_stride] += sum_of_lanes(sum_im);
  }
}

// The same sums, vectors over columns instead of sources
template <class Real>
FLOE_INLINE void multiply_tile(const RowBlock<Real>& block) {
  constexpr Index kL = kLanes<Real>, kNumbers = 2 * kTile;
  constexpr Index kVectors = kNumbers / kL;
  const Real* value = block.value;
  for (Index row = 0; row < block.rows; ++row) {
    Lanes<Real> sum[kVectors][kL] = {};
    for (Index b = 0; b < block.vectors; ++b, value += kL) {
      const Real* const q = block.charges + kNumbers * static_cast<Index>(block.start[b]);
      for (Index l = 0; l < kL; ++l)
        for (Index v = 0; v < kVectors; ++v) {
          Lanes<Real> charge;
          load(charge, q + kNumbers * l + kL * v);
          sum[v][l] += value[l] * charge;
        }
    }
    for (Index v = 0; v < kVectors; ++v) {
      for (Index width = kL / 2; width > 0; width /= 2)
        for (Index l = 0; l < width; ++l) sum[v][l] += sum[v][l + width];
      for (Index l = 0; l < kL; ++l) {
        const Index number = kL * v + l, column = number % kTile, part = number / kTile;
        block.potentials[row + (2 * column + part) * block.potential_stride] += sum[v][0][l];
      }
    }
  }
}

FLOE_SIMD_CLONES void multiply_rows(const RowBlock<float>& block) { multiply_column(block); }
FLOE_SIMD_CLONES void multiply_rows(const RowBlock<double>& block) { multiply_column(block); }
FLOE_SIMD_CLONES void multiply_tile_rows(const RowBlock<float>& block) { multiply_tile(block); }
FLOE_SIMD_CLONES void multiply_tile_rows(const RowBlock<double>& block) { multiply_tile(block); }

// kTile columns from `first` on as the tile wants them
template <class Real>
void fill_tile(const SortedColumns<Real>& charges, Index first, Real* tile) {
#pragma omp parallel for schedule(static)
  for (Index k = 0; k < charges.stride(); ++k)
    for (Index c = 0; c < kTile; ++c) {
      tile[2 * kTile * k + c] = charges.re(first + c)[k];
      tile[2 * kTile * k + kTile + c] = charges.im(first + c)[k];
    }
}

// What building a row of the near matrix needs, one a thread
template <class Real>
struct RowBuilder {
  explicit RowBuilder(const Precorrection<Real>& grid_values) : box(grid_values) {}

  // Values of the pairs of target t, near sources in the order of `sources`
  void build(const Geometry& geometry, const RadialKernel& kernel, Index t) {
    const std::size_t count = sources.size();
    distance.resize(count);
    exact.resize(count);
    value.resize(count);
    box.fill(t);
    box.values(sources, value.data());
    const Point2 target = geometry.targets().position.col(t);
    for (std::size_t k = 0; k < count; ++k)
      distance[k] = (geometry.sources.position.col(sources[k]) - target).norm();
    asked = distance;
    std::replace(asked.begin(), asked.end(), 0.0, geometry.grid.spacing);
    kernel.evaluate(asked, exact);
    // Coincident points have no kernel
    for (std::size_t k = 0; k < count; ++k)
      value[k] = static_cast<Real>((distance[k] > 0.0 ? exact[k].real() : 0.0) -
                                   static_cast<double>(value[k]));
  }

  typename Precorrection<Real>::Box box;
  std::vector<std::int32_t> sources;
  std::vector<double> distance, asked;
  std::vector<Complex> exact;
  std::vector<Real> value;
};

}  // namespace

template <class Real>
NearPart<Real>::NearPart(const Geometry& geometry, const Precorrection<Real>& grid_values,
                         const RadialKernel& kernel)
    : value_(static_cast<std::size_t>(geometry.value_begin.back())) {
  const Grid& grid = geometry.grid;
  const CellPoints& targets = geometry.targets();
#pragma omp parallel
  {
    RowBuilder<Real> builder(grid_values);
    std::vector<Index> counts;
#pragma omp for schedule(dynamic, 1)
    for (Index cy = 0; cy < grid.cells_y(); ++cy)
      for (Index cx = 0; cx < grid.cells_x(); ++cx) {
        const Index cell = cx + grid.cells_x() * cy;
        const Index first = targets.cell_begin[cell], last = targets.cell_begin[cell + 1];
        if (first == last) continue;
        builder.sources.clear();
        counts.clear();
        for_near_ranges(grid, geometry.near, geometry.sources.cell_begin, cx, cy,
                        [&](Index begin, Index end) {
                          counts.push_back(end - begin);
                          for (Index s = begin; s < end; ++s)
                            builder.sources.push_back(static_cast<std::int32_t>(s));
                        });
        Real* to = value_.data() + geometry.value_begin[cell];
        for (Index t = first; t < last; ++t) {
          builder.build(geometry, kernel, t);
          const Real* from = builder.value.data();
          for (const Index count : counts) {
            std::copy_n(from, count, to);
            from += count;
            to += whole_lanes<Real>(count);
          }
        }
      }
  }
}

template <class Real>
void NearPart<Real>::multiply_add(const Geometry& geometry, const SortedColumns<Real>& charges,
                                  const SortedColumns<Real>& potentials) const {
  const Index columns = charges.columns(), in_tiles = columns / kTile * kTile;
  const LaneBuffer<Real> tile(in_tiles > 0 ? 2 * kTile * charges.stride() : 0);
  for (Index column = 0; column < in_tiles; column += kTile) {
    fill_tile(charges, column, tile.data());
    for_rows(geometry, [&](RowBlock<Real> block, Index first) {
      block.charges = tile.data();
      block.potentials = potentials.re(column) + first;
      block.potential_stride = potentials.stride();
      multiply_tile_rows(block);
    });
  }
  for (Index column = in_tiles; column < columns; ++column)
    for_rows(geometry, [&](RowBlock<Real> block, Index first) {
      block.charges = charges.re(column);
      block.charge_stride = charges.stride();
      block.potentials = potentials.re(column) + first;
      block.potential_stride = potentials.stride();
      multiply_rows(block);
    });
}

// Visits the rows of every cell
template <class Real>
template <class Visit>
void NearPart<Real>::for_rows(const Geometry& geometry, const Visit& visit) const {
  const Grid& grid = geometry.grid;
  const std::vector<Index>& begin = geometry.targets().cell_begin;
#pragma omp parallel for schedule(dynamic, 1)
  for (Index cy = 0; cy < grid.cells_y(); ++cy)
    for (Index cell = grid.cells_x() * cy; cell < grid.cells_x() * (cy + 1); ++cell) {
      if (begin[cell] == begin[cell + 1]) continue;
      RowBlock<Real> block{};
      block.value = value_.data() + geometry.value_begin[cell];
      block.rows = begin[cell + 1] - begin[cell];
      block.start = geometry.vector_start.data() + geometry.vector_begin[cell];
      block.vectors = geometry.vector_begin[cell + 1] - geometry.vector_begin[cell];
      visit(block, begin[cell]);
    }
}

template class NearPart<float>;
template class NearPart<double>;

}  // namespace floe::fmm::pfft
