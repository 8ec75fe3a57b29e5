#pragma once

#include "pfft/lanes.hpp"
#include "pfft/stencil.hpp"

#include <floe/fmm/pfft_plan.hpp>
#include <floe/numeric/types.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace floe::fmm::pfft {

/// The regular grid under the points. Its x is the longer side of the points' rectangle. Points
/// whose stencils begin at the same grid point (cx, cy) form a cell; cells are numbered
/// cx + cells_x·cy.
struct Grid {
  double spacing = 0.0;
  Point2 origin = Point2::Zero();  // of grid point (0, 0), axes already exchanged if so
  bool exchanged = false;          // grid x is the points' y
  int stencil = 0;
  Index nx = 0, ny = 0;

  Index cells_x() const { return nx - stencil + 1; }
  Index cells_y() const { return ny - stencil + 1; }
  /// Coordinates along the grid's axes, in spacings.
  Point2 locate(const Point2& point) const {
    const Point2 along = exchanged ? Point2(point.y(), point.x()) : point;
    return (along - origin) / spacing;
  }
  Index cell_of(const Point2& point) const {
    const Point2 position = locate(point);
    const Index cx = std::clamp<Index>(stencil_begin(position.x(), stencil), 0, cells_x() - 1);
    const Index cy = std::clamp<Index>(stencil_begin(position.y(), stencil), 0, cells_y() - 1);
    return cx + cells_x() * cy;
  }
};

/// Points in the order of their cells.
struct CellPoints {
  std::vector<std::int32_t> original;  // by sorted number
  std::vector<std::int32_t> sorted;    // by original number
  std::vector<std::int32_t> cell_x, cell_y;
  std::vector<Index> cell_begin;   // by cell, cells + 1
  std::vector<float> place_float;  // x, y from the stencil's centre [spacings]; of the two only
  std::vector<double> place;       // the one in the precision of the sums
  Points2 position;                // [m], sorted

  Index count() const { return static_cast<Index>(original.size()); }
  template <class Real>
  const Real* places() const {
    if constexpr (std::is_same_v<Real, float>)
      return place_float.data();
    else
      return place.data();
  }
};

enum class Precision { single, full };

/// Sums in single precision have errors of 3e-7, those of the FFT among them.
inline Precision precision_for(double tolerance) {
  return tolerance >= 9e-7 ? Precision::single : Precision::full;
}

/// Length of a stored range of near values: whole vectors, filled up with zeros.
inline Index padded_range(Index count, Precision precision) {
  return precision == Precision::single ? whole_lanes<float>(count) : whole_lanes<double>(count);
}

CellPoints sort_into_cells(const Grid& grid, const Points2& points, Precision precision);

inline constexpr int kLargestRadius = 9;  // cells

/// Near cells of a cell: those that come closer to it than `near_radius` spacings, at most
/// half_width[|dy|] cells away along x in row dy, |dy| ≤ radius.
struct NearShape {
  explicit NearShape(double near_radius);
  int radius;
  std::vector<int> half_width;
};

/// Runs through the near sources of a target cell as ranges of sorted numbers, row by row.
template <class Visit>
void for_near_ranges(const Grid& grid, const NearShape& shape, const std::vector<Index>& cell_begin,
                     Index cx, Index cy, const Visit& visit) {
  const Index first_row = std::max<Index>(0, cy - shape.radius);
  const Index last_row = std::min(grid.cells_y() - 1, cy + shape.radius);
  for (Index row = first_row; row <= last_row; ++row) {
    const Index half = shape.half_width[static_cast<std::size_t>(row < cy ? cy - row : row - cy)];
    const Index first = std::max<Index>(0, cx - half);
    const Index last = std::min(grid.cells_x() - 1, cx + half);
    const Index begin = cell_begin[static_cast<std::size_t>(first + grid.cells_x() * row)];
    const Index end = cell_begin[static_cast<std::size_t>(last + 1 + grid.cells_x() * row)];
    if (begin < end) visit(begin, end);
  }
}

/// Everything of a plan.
class Geometry {
 public:
  Geometry(const Grid& grid, const PfftDesign& design, const Points2& source_points,
           const Points2& target_points, Precision precision);
  const CellPoints& targets() const { return own_targets_ ? *own_targets_ : sources; }
  double memory() const;

  Grid grid;
  PfftDesign design;
  NearShape near;
  Precision precision;
  CellPoints sources;
  // Near sources of a target cell as whole vectors, values of the near matrix behind each other
  std::vector<Index> vector_begin;         // by cell, + 1: the cell's part of vector_start
  std::vector<std::int32_t> vector_start;  // first sorted source of each vector
  std::vector<Index> value_begin;          // by cell, + 1: near values of the cell's targets
  std::vector<std::pair<std::int32_t, std::int32_t>> coincident;  // sorted target, sorted source

 private:
  std::optional<CellPoints> own_targets_;  // unless they are the sources
};

}  // namespace floe::fmm::pfft
