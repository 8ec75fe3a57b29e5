#include "pfft/design.hpp"
#include "pfft/stencil_polynomials.hpp"

#include <floe/fmm/pfft_plan.hpp>
#include <floe/numeric/error.hpp>

namespace floe::fmm {
namespace {

pfft::Extent validated_extent(const Points2& sources, const Points2& targets,
                              const PfftOptions& options) {
  FLOE_VALIDATE(sources.cols() > 0 && targets.cols() > 0,
                "invalid number of points = 0 (must be positive)");
  FLOE_VALIDATE(sources.allFinite() && targets.allFinite(),
                "invalid point coordinate = nan or inf (must be finite)");
  FLOE_VALIDATE(options.tolerance >= 1e-7 && options.tolerance <= 1e-2,
                "invalid pfft tolerance = " << options.tolerance << " (must be 1e-7 to 1e-2)");
  FLOE_VALIDATE(
      options.max_wavenumber >= 0.0,
      "invalid wavenumber = " << options.max_wavenumber << " rad/m (must not be negative)");
  return pfft::extent_of(sources, targets);
}

PfftDesign chosen(const Points2& sources, const Points2& targets, const PfftOptions& options) {
  return pfft::choose_design(validated_extent(sources, targets, options), sources, targets,
                             options);
}

}  // namespace

PfftPlan::PfftPlan(const Points2& sources, const Points2& targets, const PfftOptions& options)
    : PfftPlan(sources, targets, options, chosen(sources, targets, options)) {}

PfftPlan::PfftPlan(const Points2& sources, const Points2& targets, const PfftOptions& options,
                   const PfftDesign& prescribed)
    : options_(options) {
  const pfft::Extent extent = validated_extent(sources, targets, options);
  PfftDesign design = prescribed;
  FLOE_VALIDATE(design.stencil >= 2 && design.stencil <= pfft::kWeights,
                "invalid pfft stencil = " << design.stencil << " (must be 2 to 8)");
  FLOE_VALIDATE(design.near_radius > 0.0 && design.near_radius <= pfft::kLargestRadius,
                "invalid pfft near radius = " << design.near_radius
                                              << " spacings (must be positive, at most "
                                              << pfft::kLargestRadius << ")");
  if (design.memory == 0.0)
    pfft::estimate_cost(extent, sources, targets, options.tolerance, design);
  FLOE_VALIDATE_AS(BudgetError, design.memory <= options.memory_budget,
                   "pfft memory = " << design.memory << " byte (budget " << options.memory_budget
                                    << " byte; grid of " << design.nx << " x " << design.ny
                                    << " points, " << design.near_pairs << " near pairs)");
  // The spacing of the design is what make_grid gave: ask for a hair more, get the same
  const pfft::Grid grid = pfft::make_grid(extent, design.stencil, design.spacing * (1.0 + 1e-9));
  geometry_ = std::make_shared<const pfft::Geometry>(grid, design, sources, targets,
                                                     pfft::precision_for(options.tolerance));
}

const PfftDesign& PfftPlan::design() const { return geometry_->design; }

double PfftPlan::max_distance() const {
  const pfft::Grid& grid = geometry_->grid;
  return grid.spacing * std::hypot(static_cast<double>(grid.nx), static_cast<double>(grid.ny));
}

double PfftPlan::memory() const { return geometry_->memory(); }

std::vector<Index> PfftPlan::near_sources(Index target) const {
  const pfft::Geometry& geometry = *geometry_;
  const Index t = geometry.targets().sorted[target];
  std::vector<Index> sources;
  sources.reserve(static_cast<std::size_t>(2.0 * design().near_pairs /
                                           static_cast<double>(geometry.targets().count())));
  pfft::for_near_ranges(geometry.grid, geometry.near, geometry.sources.cell_begin,
                        geometry.targets().cell_x[t], geometry.targets().cell_y[t],
                        [&](Index begin, Index end) {
                          sources.insert(sources.end(), geometry.sources.original.begin() + begin,
                                         geometry.sources.original.begin() + end);
                        });
  std::sort(sources.begin(), sources.end());
  return sources;
}

}  // namespace floe::fmm
