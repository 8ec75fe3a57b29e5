#pragma once

#include "pfft/stencil.hpp"

#include <floe/fmm/pfft_plan.hpp>
#include <floe/numeric/types.hpp>

#include <algorithm>
#include <cstdint>
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
};

/// Points in the order of their cells, with the weights of their stencils.
struct CellPoints {
  std::vector<Index> original;  // by sorted number
  std::vector<Index> sorted;    // by original number
  std::vector<std::int32_t> cell_x, cell_y;
  std::vector<Index> cell_begin;  // by cell, cells + 1
  std::vector<double> weight;     // 2·stencil a point: along x, along y
  Points2 position;               // [m], sorted

  Index count() const { return static_cast<Index>(original.size()); }
  const double* weights_x(Index k, int stencil) const { return weight.data() + 2 * stencil * k; }
  const double* weights_y(Index k, int stencil) const { return weights_x(k, stencil) + stencil; }
};

CellPoints sort_into_cells(const Grid& grid, const Points2& points);

/// Near cells of a cell: those that come closer to it than `radius` spacings; at most
/// half_width[|dy|] cells away along x in row dy.
struct NearShape {
  explicit NearShape(int radius);
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
  Geometry(const Grid& grid, const PfftDesign& design, const Points2& sources,
           const Points2& targets);
  Grid grid;
  PfftDesign design;
  NearShape near;
  CellPoints sources, targets;
  std::vector<Index> near_length;  // stored near values of a target, by target cell
  std::vector<Index> near_begin;   // and where those of the cell begin
  double memory() const;
};

}  // namespace floe::fmm::pfft
