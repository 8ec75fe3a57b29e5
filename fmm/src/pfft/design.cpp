#include "pfft/design.hpp"

#include "pfft/near_part.hpp"

#include <floe/fmm/padded_grid.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace floe::fmm::pfft {
namespace {

// Tuning constants: nanoseconds on one core, flat within 20 % of the best over a factor of two
constexpr double kFftTime = 15.0;      // a padded grid point, both transforms
constexpr double kStencilTime = 1.1;   // a stencil point of a source or a target
constexpr double kPointTime = 12.0;    // a source or a target
constexpr double kNearTime = 0.9;      // a near pair
constexpr double kNearRowTime = 20.0;  // a row of near pairs

// Error of random charges under 1/R with stencil w and near radius r = 1 … 8. It does not depend on
// the spacing; waves on top of 1/R make it smaller. Measured by `bench_pfft_sum 120 0`, and the
// spread between meshes added.
constexpr int kRadii = 8;
struct MeasuredError {
  int stencil;
  double at_radius[kRadii];
};
constexpr MeasuredError kMeasured[] = {
    {3, {9.0e-3, 2.4e-3, 8.6e-4, 4.3e-4, 2.5e-4, 1.4e-4, 1.0e-4, 7.4e-5}},
    {4, {7.6e-3, 1.2e-3, 3.5e-4, 1.6e-4, 7.9e-5, 3.8e-5, 2.2e-5, 1.4e-5}},
    {5, {5.4e-3, 5.6e-4, 1.3e-4, 4.0e-5, 1.6e-5, 6.5e-6, 3.7e-6, 1.7e-6}},
    {6, {6.5e-3, 3.7e-4, 4.1e-5, 1.0e-5, 3.4e-6, 1.3e-6, 5.8e-7, 2.8e-7}},
    {7, {4.9e-3, 3.6e-4, 4.0e-5, 8.3e-6, 2.4e-6, 6.2e-7, 2.6e-7, 1.0e-7}},
    {8, {6.0e-3, 2.3e-4, 3.2e-5, 5.4e-6, 1.2e-6, 2.8e-7, 1.0e-7, 3.7e-8}},
    {9, {4.4e-3, 2.8e-4, 2.6e-5, 4.4e-6, 9.4e-7, 1.7e-7, 4.9e-8, 1.6e-8}},
    {10, {5.5e-3, 2.2e-4, 2.9e-5, 3.2e-6, 6.1e-7, 7.3e-8, 2.3e-8, 4.1e-9}},
};

// Wavenumber · spacing at which plane waves have this error, by the order of the stencil
double largest_phase(int stencil, double error) {
  const double phase = 0.5 * std::pow(error / stencil_wave_error(stencil, 0.5), 1.0 / stencil);
  return std::min(phase, 1.2);
}

// How much larger sums of random charges are under the kernel than under 2/R: root of the ratio of
// Σ|G|² to Σ(2/R)², at a few targets spread over all
double strength(const RadialKernel& kernel, const Points2& sources, const Points2& targets) {
  constexpr int kTargets = 8;
  double kernel_sum = 0.0, reference_sum = 0.0;
  std::vector<double> distance(static_cast<std::size_t>(sources.cols()));
  std::vector<Complex> value(distance.size());
  for (int s = 0; s < kTargets; ++s) {
    const Index target = targets.cols() * (2 * s + 1) / (2 * kTargets);
    for (Index j = 0; j < sources.cols(); ++j) {
      const double r = (sources.col(j) - targets.col(target)).norm();
      distance[j] = r > 0.0 ? r : 1e300;
    }
    // Coincident points count as far away: put them at the largest distance
    double largest = 0.0;
    for (const double r : distance) largest = r < 1e300 ? std::max(largest, r) : largest;
    if (largest == 0.0) continue;
    for (double& r : distance) r = std::min(r, largest);
    kernel.evaluate(distance, value);
    for (std::size_t j = 0; j < distance.size(); ++j) {
      kernel_sum += std::norm(value[j]);
      reference_sum += 4.0 / (distance[j] * distance[j]);
    }
  }
  return reference_sum > 0.0 ? std::sqrt(kernel_sum / reference_sum) : 1.0;
}

}  // namespace

Extent extent_of(const Points2& sources, const Points2& targets) {
  Extent extent;
  extent.low = sources.rowwise().minCoeff().cwiseMin(targets.rowwise().minCoeff());
  extent.high = sources.rowwise().maxCoeff().cwiseMax(targets.rowwise().maxCoeff());
  extent.exchanged = extent.high.y() - extent.low.y() > extent.high.x() - extent.low.x();
  if (extent.exchanged) {
    std::swap(extent.low.x(), extent.low.y());
    std::swap(extent.high.x(), extent.high.y());
  }
  return extent;
}

Grid make_grid(const Extent& extent, int stencil, double spacing) {
  Grid grid;
  grid.exchanged = extent.exchanged;
  grid.stencil = stencil;
  const Point2 size = extent.high - extent.low;
  // One interval more than the points need: rounding may put the last point behind its end
  const double intervals = std::ceil(size.x() / spacing);
  grid.nx = fast_fft_length(2 * (static_cast<Index>(intervals) + stencil + 1)) / 2;
  const auto free_intervals = static_cast<double>(grid.nx - stencil - 1);
  grid.spacing = size.x() > 0.0 ? size.x() / free_intervals : spacing;
  grid.ny = static_cast<Index>(std::ceil(size.y() / grid.spacing)) + stencil + 1;
  grid.origin = extent.low - Point2::Constant(grid.spacing * ((stencil - 1) / 2));
  return grid;
}

void estimate_cost(const Extent& extent, const Points2& sources, const Points2& targets,
                   double tolerance, PfftDesign& design) {
  const Grid grid = make_grid(extent, design.stencil, design.spacing);
  design.spacing = grid.spacing;
  design.nx = grid.nx;
  design.ny = grid.ny;
  const auto padded = static_cast<double>(fast_fft_length(2 * grid.nx)) *
                      static_cast<double>(fast_fft_length(2 * grid.ny));
  const auto points = static_cast<double>(sources.cols() + targets.cols());
  const double entry = near_in_float(tolerance) ? 8.0 : 16.0;

  // Grid: spectrum, data, row spectra, cells; without near pairs it may be too large already
  design.near_pairs = 0.0;
  design.memory = padded * (4.0 + 4.0 + 8.0 + 8.0) + points * (16.0 * design.stencil + 56.0);
  if (padded > 1e9) {
    design.nanoseconds = kFftTime * padded;
    return;
  }

  // Near pairs, counted cell by cell
  const auto count_cells = [&](const Points2& at) {
    std::vector<Index> begin(static_cast<std::size_t>(grid.cells_x() * grid.cells_y() + 1), 0);
    for (Index i = 0; i < at.cols(); ++i) {
      const Point2 position = grid.locate(at.col(i));
      const Index cx =
          std::clamp<Index>(stencil_begin(position.x(), grid.stencil), 0, grid.cells_x() - 1);
      const Index cy =
          std::clamp<Index>(stencil_begin(position.y(), grid.stencil), 0, grid.cells_y() - 1);
      ++begin[cx + grid.cells_x() * cy + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    return begin;
  };
  const std::vector<Index> source = count_cells(sources), target = count_cells(targets);
  const NearShape shape(design.near_radius);
  for (Index cell = 0; cell < grid.cells_x() * grid.cells_y(); ++cell) {
    const Index here = target[cell + 1] - target[cell];
    if (here == 0) continue;
    Index near = 0;
    for_near_ranges(grid, shape, source, cell % grid.cells_x(), cell / grid.cells_x(),
                    [&](Index begin, Index end) { near += padded_range(end - begin); });
    design.near_pairs += static_cast<double>(here) * static_cast<double>(near);
  }
  design.memory += entry * design.near_pairs;
  design.nanoseconds = kFftTime * padded + kNearTime * entry / 8.0 * design.near_pairs +
                       kNearRowTime * static_cast<double>(targets.cols()) +
                       points * (kPointTime + kStencilTime * design.stencil * design.stencil);
}

PfftDesign choose_design(const Extent& extent, const Points2& sources, const Points2& targets,
                         const PfftOptions& options) {
  PfftDesign best;
  const Point2 size = extent.high - extent.low;
  const double area = std::max(size.x() * size.y(), 1e-12 * size.x() * size.x());
  const double density = static_cast<double>(sources.cols()) / std::max(area, 1e-300);
  // What the waves of a typical kernel allow, and half of the tolerance kept in reserve then; its
  // logarithm, of the wave part, costs accuracy at distances where it outweighs 2/R (shallow water)
  double credit = 1.0, logarithm = 0.0, tolerance = options.tolerance;
  if (options.typical_kernel) {
    credit = std::max(1.0, strength(*options.typical_kernel, sources, targets));
    logarithm = 2.0 * std::abs(options.typical_kernel->wave().coefficient) / std::numbers::pi;
    tolerance *= 0.5;
  }
  for (const MeasuredError& measured : kMeasured) {
    for (int radius = 1; radius <= kRadii; ++radius) {
      const double near = measured.at_radius[radius - 1] / credit;
      if (near > tolerance) continue;
      // Coarsest spacing at which the waves are right, then finer ones by the cost
      const double left = std::sqrt(tolerance * tolerance - near * near);
      double largest = 2.0 / std::sqrt(density);
      if (options.max_wavenumber > 0.0)
        largest = std::min(largest, largest_phase(measured.stencil, left) / options.max_wavenumber);
      for (double spacing = largest; spacing > largest / 20.0; spacing *= 0.8) {
        if (near * (1.0 + logarithm * radius * spacing / measured.stencil) > tolerance) continue;
        PfftDesign design{.stencil = measured.stencil, .near_radius = radius, .spacing = spacing};
        estimate_cost(extent, sources, targets, options.tolerance, design);
        if (best.stencil == 0 || design.nanoseconds < best.nanoseconds)
          best = design;
        else if (design.nanoseconds > 2.0 * best.nanoseconds)
          break;
      }
      break;
    }
  }
  FLOE_VALIDATE_AS(BudgetError, best.stencil > 0,
                   "pfft tolerance = " << options.tolerance << " (no stencil is accurate enough)");
  return best;
}

}  // namespace floe::fmm::pfft
