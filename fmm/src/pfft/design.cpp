#include "pfft/design.hpp"

#include "pfft/lane_fft.hpp"
#include "pfft/near_counter.hpp"

#include <floe/numeric/error.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

namespace floe::fmm::pfft {
namespace {

// Tuning constants: nanoseconds on one core in single precision, twice that in double; flat within
// 20 % of the best over a factor of two
constexpr double kFftTime = 7.0;       // a padded grid point, both transforms
constexpr double kStencilTime = 2.0;   // a stencil's row, of a source or a target
constexpr double kPointTime = 3.0;     // a source or a target
constexpr double kNearTime = 0.5;      // a stored near value
constexpr double kNearRowTime = 20.0;  // a row of near pairs

// Error of random charges under 2/R with stencil w and near radius r, the largest of jittered,
// random and graded points. It does not depend on the spacing; waves on top of 2/R make it smaller.
// `bench_pfft_sum 80 0` measures the jittered ones again. A sixth is added.
constexpr double kSpread = 7.0 / 6.0;
constexpr double kRadii[] = {1.4, 2.0, 2.2, 2.5, 3.0, 3.1, 3.5, 4.0,
                             4.2, 5.0, 5.5, 6.0, 6.5, 7.0, 7.5, 8.0};
struct MeasuredError {
  int stencil;
  double at_radius[std::size(kRadii)];
};
constexpr MeasuredError kMeasured[] = {
    {4,
     {1.5e-3, 1.0e-3, 4.8e-4, 3.1e-4, 2.7e-4, 1.6e-4, 1.4e-4, 1.2e-4, 6.8e-5, 6.3e-5, 3.2e-5,
      2.9e-5, 1.9e-5, 1.8e-5, 1.2e-5, 1.1e-5}},
    {5,
     {6.4e-4, 4.5e-4, 1.8e-4, 1.1e-4, 9.6e-5, 4.7e-5, 3.5e-5, 3.1e-5, 1.4e-5, 1.3e-5, 5.9e-6,
      5.9e-6, 2.8e-6, 2.8e-6, 1.6e-6, 1.4e-6}},
    {6,
     {6.7e-4, 2.9e-4, 1.6e-4, 6.0e-5, 3.6e-5, 2.1e-5, 1.2e-5, 7.9e-6, 4.3e-6, 2.8e-6, 1.1e-6,
      1.0e-6, 5.1e-7, 5.0e-7, 2.6e-7, 2.3e-7}},
    {7,
     {4.2e-4, 2.8e-4, 1.3e-4, 3.7e-5, 3.5e-5, 2.6e-5, 1.1e-5, 6.0e-6, 3.5e-6, 1.9e-6, 6.5e-7,
      5.2e-7, 2.2e-7, 2.1e-7, 1.0e-7, 8.7e-8}},
    {8,
     {4.6e-4, 1.8e-4, 1.1e-4, 3.4e-5, 2.7e-5, 1.5e-5, 1.0e-5, 4.2e-6, 1.9e-6, 1.0e-6, 3.6e-7,
      2.2e-7, 1.1e-7, 8.0e-8, 3.9e-8, 3.2e-8}},
};

// Error of random charges under ln R in spacings, relative to that under 2/R: at most this
double logarithm_share(double radius) { return 0.5 + 0.23 * radius; }

constexpr double kShareWithKernel = 0.8;  // of the tolerance, with a typical kernel
constexpr double kLargestPhase = 1.2;     // wavenumber · spacing

// Rounding of sums in single precision, those of the FFT among it
constexpr double kSingleRounding = 3e-7;

Index fast_length(Index least) { return LaneFft<float>::fast_length(least); }

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
  grid.nx = fast_length(2 * (static_cast<Index>(intervals) + stencil + 1)) / 2;
  const auto free_intervals = static_cast<double>(grid.nx - stencil - 1);
  grid.spacing = size.x() > 0.0 ? size.x() / free_intervals : spacing;
  grid.ny = static_cast<Index>(std::ceil(size.y() / grid.spacing)) + stencil + 1;
  const int before = (stencil - 1) / 2;  // grid points in front of the first cell
  grid.origin = extent.low - Point2::Constant(grid.spacing * before);
  return grid;
}

namespace {

std::vector<Index> count_cells(const Grid& grid, const Points2& points) {
  std::vector<Index> begin(static_cast<std::size_t>(grid.cells_x() * grid.cells_y() + 1), 0);
  for (Index i = 0; i < points.cols(); ++i) ++begin[grid.cell_of(points.col(i)) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  return begin;
}

// Time and memory from the number of near pairs
void add_up(const Grid& grid, Index sources, Index targets, double stored_near, double tolerance,
            PfftDesign& design) {
  const double real = precision_for(tolerance) == Precision::single ? 4.0 : 8.0;
  const auto padded =
      static_cast<double>(fast_length(2 * grid.nx)) * static_cast<double>(fast_length(2 * grid.ny));
  const auto points = static_cast<double>(sources + targets);
  design.spacing = grid.spacing;
  design.nx = grid.nx;
  design.ny = grid.ny;
  // Spectrum; grid and row spectra; cells. Points: weights, positions, a column
  design.memory =
      padded * (0.5 * real + 1.5 * real + 8.0) + points * (4.0 * real + 40.0) + real * stored_near;
  design.nanoseconds =
      real / 4.0 *
      (kFftTime * padded + kNearTime * stored_near + kNearRowTime * static_cast<double>(targets) +
       points * (kPointTime + kStencilTime * design.stencil));
}

constexpr double kLargestGrid = 1e9;  // padded points

bool fits(const Grid& grid) {
  return 4.0 * static_cast<double>(grid.nx) * static_cast<double>(grid.ny) < kLargestGrid;
}

}  // namespace

void estimate_cost(const Extent& extent, const Points2& sources, const Points2& targets,
                   double tolerance, PfftDesign& design) {
  const Grid grid = make_grid(extent, design.stencil, design.spacing);
  const Precision precision = precision_for(tolerance);
  design.near_pairs = 0.0;
  double stored = 0.0;
  if (fits(grid)) {
    // Count near pairs cell by cell
    const std::vector<Index> source = count_cells(grid, sources),
                             target = count_cells(grid, targets);
    const NearShape shape(design.near_radius);
    for (Index cell = 0; cell < grid.cells_x() * grid.cells_y(); ++cell) {
      const auto here = static_cast<double>(target[cell + 1] - target[cell]);
      if (here == 0.0) continue;
      for_near_ranges(grid, shape, source, cell % grid.cells_x(), cell / grid.cells_x(),
                      [&](Index begin, Index end) {
                        design.near_pairs += here * static_cast<double>(end - begin);
                        stored += here * static_cast<double>(padded_range(end - begin, precision));
                      });
    }
  }
  add_up(grid, sources.cols(), targets.cols(), stored, tolerance, design);
}

PfftDesign choose_design(const Extent& extent, const Points2& sources, const Points2& targets,
                         const PfftOptions& options) {
  const Point2 size = extent.high - extent.low;
  const double area = std::max(size.x() * size.y(), 1e-12 * size.x() * size.x());
  const double mean_spacing = std::sqrt(area / static_cast<double>(sources.cols()));
  const Precision precision = precision_for(options.tolerance);
  const auto target_count = static_cast<double>(targets.cols());
  const double rounding = precision == Precision::single ? kSingleRounding : 0.0;
  const NearCounter counter(sources, targets);

  // What the waves of a typical kernel allow, and a part of the tolerance kept in reserve then; its
  // logarithm, of the wave part, costs accuracy at distances where it outweighs 2/R (shallow water)
  double credit = 1.0, logarithm = 0.0, tolerance = options.tolerance;
  if (options.typical_kernel) {
    credit = std::max(1.0, strength(*options.typical_kernel, sources, targets));
    logarithm = 2.0 * std::abs(options.typical_kernel->wave().coefficient) / std::numbers::pi;
    tolerance *= kShareWithKernel;
  }

  // Of each stencil the two smallest near radii that may do; coarse spacings first
  PfftDesign best;
  for (const MeasuredError& measured : kMeasured) {
    int radii = 0;
    for (std::size_t r = 0; r < std::size(kRadii) && radii < 2; ++r) {
      const double near = kSpread * measured.at_radius[r] / credit;
      if (std::hypot(near, rounding) > tolerance) continue;
      double least = std::numeric_limits<double>::infinity();
      for (double spacing = 2.0 * mean_spacing; spacing > 0.02 * mean_spacing; spacing *= 0.85) {
        const double with_logarithm =
            near * (1.0 + logarithm * spacing * logarithm_share(kRadii[r]));
        const double phase = options.max_wavenumber * spacing;
        if (phase > kLargestPhase ||
            std::hypot(with_logarithm, stencil_wave_error(measured.stencil, phase), rounding) >
                tolerance)
          continue;
        PfftDesign design{
            .stencil = measured.stencil, .near_radius = kRadii[r], .spacing = spacing};
        const Grid grid = make_grid(extent, design.stencil, design.spacing);
        if (!fits(grid)) break;
        const NearCounter::Lengths near_lengths =
            counter.near_lengths(grid, NearShape(design.near_radius), precision);
        design.near_pairs = target_count * near_lengths.pairs;
        add_up(grid, sources.cols(), targets.cols(), target_count * near_lengths.stored,
               options.tolerance, design);
        if (best.stencil == 0 || design.nanoseconds < best.nanoseconds) best = design;
        least = std::min(least, design.nanoseconds);
        if (design.nanoseconds > 1.5 * least) break;
      }
      if (std::isfinite(least)) ++radii;
    }
  }
  FLOE_VALIDATE_AS(BudgetError, best.stencil > 0,
                   "pfft tolerance = " << options.tolerance << " (no stencil is accurate enough)");
  best.memory = 0.0;
  estimate_cost(extent, sources, targets, options.tolerance, best);
  return best;
}

}  // namespace floe::fmm::pfft
