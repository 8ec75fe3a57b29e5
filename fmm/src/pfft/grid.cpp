#include "pfft/grid.hpp"

#include <floe/numeric/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace floe::fmm::pfft {

NearShape::NearShape(double near_radius) : radius(0) {
  // Near are cells that come closer than the radius; a cell is a spacing wide
  const double reach = near_radius * near_radius * (1.0 - 1e-6);
  for (int gap = 0; gap == 0 || gap * gap < reach; ++gap) {
    int along = 0;
    while ((along + 1) * (along + 1) + gap * gap < reach) ++along;
    for (int dy = gap == 0 ? 0 : gap + 1; dy <= gap + 1; ++dy) half_width.push_back(along + 1);
    radius = gap + 1;
  }
}

namespace {

template <class Real>
void fill_places(const Grid& grid, const Points2& points, const CellPoints& cells,
                 std::vector<Real>& place) {
  place.resize(static_cast<std::size_t>(2 * cells.count()));
  const double centre = 0.5 * (grid.stencil - 1);
#pragma omp parallel for schedule(static)
  for (Index k = 0; k < cells.count(); ++k) {
    const Point2 position = grid.locate(points.col(cells.original[k]));
    place[2 * k] = static_cast<Real>(position.x() - static_cast<double>(cells.cell_x[k]) - centre);
    place[2 * k + 1] =
        static_cast<Real>(position.y() - static_cast<double>(cells.cell_y[k]) - centre);
  }
}

}  // namespace

CellPoints sort_into_cells(const Grid& grid, const Points2& points, Precision precision) {
  const Index count = points.cols();
  CellPoints cells;
  cells.cell_begin.assign(static_cast<std::size_t>(grid.cells_x() * grid.cells_y() + 1), 0);

  // Count and order by cell; within a cell the order of the points stays
  FLOE_VALIDATE(count <= std::numeric_limits<std::int32_t>::max(),
                "invalid number of points = " << count << " (must be below 2^31)");
  std::vector<Index> cell(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i) {
    cell[i] = grid.cell_of(points.col(i));
    ++cells.cell_begin[cell[i] + 1];
  }
  std::partial_sum(cells.cell_begin.begin(), cells.cell_begin.end(), cells.cell_begin.begin());
  std::vector<Index> next(cells.cell_begin.begin(), cells.cell_begin.end() - 1);
  cells.original.resize(count);
  cells.sorted.resize(count);
  for (Index i = 0; i < count; ++i) {
    cells.sorted[i] = static_cast<std::int32_t>(next[cell[i]]++);
    cells.original[cells.sorted[i]] = static_cast<std::int32_t>(i);
  }

  cells.position.resize(2, count);
  cells.cell_x.resize(count);
  cells.cell_y.resize(count);
#pragma omp parallel for schedule(static)
  for (Index k = 0; k < count; ++k) {
    const Index i = cells.original[k];
    cells.position.col(k) = points.col(i);
    cells.cell_x[k] = static_cast<std::int32_t>(cell[i] % grid.cells_x());
    cells.cell_y[k] = static_cast<std::int32_t>(cell[i] / grid.cells_x());
  }
  if (precision == Precision::single)
    fill_places(grid, points, cells, cells.place_float);
  else
    fill_places(grid, points, cells, cells.place);
  return cells;
}

Geometry::Geometry(const Grid& grid_in, const PfftDesign& design_in, const Points2& source_points,
                   const Points2& target_points, Precision precision_in)
    : grid(grid_in),
      design(design_in),
      near(design_in.near_radius),
      precision(precision_in),
      sources(sort_into_cells(grid, source_points, precision)) {
  const bool same = source_points.cols() == target_points.cols() && source_points == target_points;
  if (!same) own_targets_ = sort_into_cells(grid, target_points, precision);

  // List near vectors, find coincident points
  const CellPoints& to = targets();
  const Index lanes = padded_range(1, precision);
  vector_begin.push_back(0);
  value_begin.push_back(0);
  for (Index cy = 0; cy < grid.cells_y(); ++cy)
    for (Index cx = 0; cx < grid.cells_x(); ++cx) {
      const Index cell = cx + grid.cells_x() * cy;
      const Index first = to.cell_begin[cell], last = to.cell_begin[cell + 1];
      if (last > first)
        for_near_ranges(grid, near, sources.cell_begin, cx, cy, [&](Index begin, Index end) {
          for (Index s = begin; s < end; s += lanes)
            vector_start.push_back(static_cast<std::int32_t>(s));
        });
      vector_begin.push_back(static_cast<Index>(vector_start.size()));
      value_begin.push_back(value_begin.back() +
                            (last - first) * lanes * (vector_begin[cell + 1] - vector_begin[cell]));
      for (Index t = first; t < last; ++t)
        for (Index s = sources.cell_begin[cell]; s < sources.cell_begin[cell + 1]; ++s)
          if (to.position.col(t) == sources.position.col(s))
            coincident.emplace_back(static_cast<std::int32_t>(t), static_cast<std::int32_t>(s));
    }
}

double Geometry::memory() const {
  const double real = precision == Precision::single ? 4.0 : 8.0;
  const auto points = static_cast<double>(sources.count() + (own_targets_ ? targets().count() : 0));
  return points * (2.0 * real + 32.0) + 8.0 * static_cast<double>(coincident.size()) +
         8.0 * static_cast<double>((own_targets_ ? 4 : 3) * value_begin.size()) +
         4.0 * static_cast<double>(vector_start.size());
}

}  // namespace floe::fmm::pfft
