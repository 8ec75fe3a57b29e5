#include "pfft/grid.hpp"

#include "pfft/near_part.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace floe::fmm::pfft {

NearShape::NearShape(int near_radius) : radius(near_radius) {
  // Near are cells that come closer than the radius; a cell is a spacing wide
  for (int dy = 0; dy <= radius; ++dy) {
    const double gap = std::max(0, dy - 1), reach = radius - 1e-6;
    half_width.push_back(
        std::min(radius, 1 + static_cast<int>(std::sqrt(reach * reach - gap * gap))));
  }
}

CellPoints sort_into_cells(const Grid& grid, const Points2& points) {
  const Index count = points.cols();
  CellPoints cells;
  cells.cell_begin.assign(static_cast<std::size_t>(grid.cells_x() * grid.cells_y() + 1), 0);

  // Count and order by cell; within a cell the order of the points stays
  std::vector<Index> cell(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i) {
    const Point2 position = grid.locate(points.col(i));
    const Index cx =
        std::clamp<Index>(stencil_begin(position.x(), grid.stencil), 0, grid.cells_x() - 1);
    const Index cy =
        std::clamp<Index>(stencil_begin(position.y(), grid.stencil), 0, grid.cells_y() - 1);
    cell[i] = cx + grid.cells_x() * cy;
    ++cells.cell_begin[cell[i] + 1];
  }
  std::partial_sum(cells.cell_begin.begin(), cells.cell_begin.end(), cells.cell_begin.begin());
  std::vector<Index> next(cells.cell_begin.begin(), cells.cell_begin.end() - 1);
  cells.original.resize(count);
  cells.sorted.resize(count);
  for (Index i = 0; i < count; ++i) {
    cells.sorted[i] = next[cell[i]]++;
    cells.original[cells.sorted[i]] = i;
  }

  // Keep positions and the weights of the stencils
  const int w = grid.stencil;
  cells.position.resize(2, count);
  cells.cell_x.resize(count);
  cells.cell_y.resize(count);
  cells.weight.resize(static_cast<std::size_t>(2 * w * count));
#pragma omp parallel for schedule(static)
  for (Index k = 0; k < count; ++k) {
    const Index i = cells.original[k];
    cells.position.col(k) = points.col(i);
    cells.cell_x[k] = static_cast<std::int32_t>(cell[i] % grid.cells_x());
    cells.cell_y[k] = static_cast<std::int32_t>(cell[i] / grid.cells_x());
    const Point2 position = grid.locate(points.col(i));
    double* const weight = cells.weight.data() + 2 * w * k;
    stencil_weights(position.x() - static_cast<double>(cells.cell_x[k]), w, weight);
    stencil_weights(position.y() - static_cast<double>(cells.cell_y[k]), w, weight + w);
  }
  return cells;
}

Geometry::Geometry(const Grid& grid_in, const PfftDesign& design_in, const Points2& source_points,
                   const Points2& target_points)
    : grid(grid_in),
      design(design_in),
      near(design_in.near_radius),
      sources(sort_into_cells(grid, source_points)),
      targets(sort_into_cells(grid, target_points)) {
  const Index cells = grid.cells_x() * grid.cells_y();
  near_length.assign(static_cast<std::size_t>(cells), 0);
  near_begin.assign(static_cast<std::size_t>(cells + 1), 0);
  for (Index cell = 0; cell < cells; ++cell) {
    const Index here = targets.cell_begin[cell + 1] - targets.cell_begin[cell];
    if (here > 0)
      for_near_ranges(
          grid, near, sources.cell_begin, cell % grid.cells_x(), cell / grid.cells_x(),
          [&](Index begin, Index end) { near_length[cell] += padded_range(end - begin); });
    near_begin[cell + 1] = near_begin[cell] + here * near_length[cell];
  }
}

double Geometry::memory() const {
  const auto points = static_cast<double>(sources.count() + targets.count());
  return points * (16.0 * grid.stencil + 40.0) + 8.0 * static_cast<double>(4 * near_length.size());
}

}  // namespace floe::fmm::pfft
