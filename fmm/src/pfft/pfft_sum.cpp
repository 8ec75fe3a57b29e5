#include "pfft/design.hpp"
#include "pfft/near_part.hpp"
#include "pfft/near_table.hpp"
#include "pfft/projection.hpp"

#include <floe/fmm/grid_convolution.hpp>
#include <floe/fmm/pfft_sum.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace floe::fmm {
namespace {

// The kernel at the grid's offsets (i, j) ≥ 0, x fastest; at (0, 0), which only near pairs see and
// precorrection takes out again, half a spacing away
std::vector<Complex> kernel_table(const pfft::Grid& grid, const RadialKernel& kernel) {
  std::vector<Complex> table(static_cast<std::size_t>(grid.nx * grid.ny));
#pragma omp parallel
  {
    std::vector<double> distance(static_cast<std::size_t>(grid.nx));
#pragma omp for schedule(static)
    for (Index j = 0; j < grid.ny; ++j) {
      for (Index i = 0; i < grid.nx; ++i)
        distance[i] = grid.spacing * std::hypot(static_cast<double>(i), static_cast<double>(j));
      if (j == 0) distance[0] = 0.5 * grid.spacing;
      kernel.evaluate(distance, {table.data() + grid.nx * j, static_cast<std::size_t>(grid.nx)});
    }
  }
  return table;
}

GridConvolution make_convolution(const pfft::Grid& grid, const std::vector<Complex>& table) {
  auto padded = std::make_shared<const PaddedGrid>(grid.nx, grid.ny);
  EvenSpectrum spectrum(*padded, [&](Index i, Index j) { return table[i + grid.nx * j]; });
  return {std::move(padded), std::move(spectrum)};
}

}  // namespace

struct PfftSum::State {
  State(const pfft::Geometry& geometry, const std::vector<Complex>& table)
      : convolution(make_convolution(geometry.grid, table)),
        grid_values(geometry, [&](Index i, Index j) { return table[i + geometry.grid.nx * j]; }) {}

  GridConvolution convolution;
  pfft::Precorrection grid_values;
  std::variant<std::monostate, pfft::NearPart<float>, pfft::NearPart<double>> near;
};

PfftSum::PfftSum(std::shared_ptr<const PfftPlan> plan, const RadialKernel& kernel, Parts parts)
    : plan_(std::move(plan)) {
  const double wavenumber = kernel.wave().wavenumber;
  FLOE_VALIDATE(wavenumber <= plan_->options().max_wavenumber * (1.0 + 1e-9),
                "invalid wavenumber = " << wavenumber << " rad/m (the plan allows "
                                        << plan_->options().max_wavenumber << ")");
  const pfft::Geometry& geometry = plan_->geometry();
  std::vector<Complex> table = kernel_table(geometry.grid, kernel);
  pfft::fit_near_table(geometry.grid, geometry.near, kernel, table);
  auto state = std::make_unique<State>(geometry, table);
  if (parts == Parts::all) {
    if (pfft::near_in_float(plan_->options().tolerance))
      state->near.emplace<pfft::NearPart<float>>(geometry, state->grid_values, kernel);
    else
      state->near.emplace<pfft::NearPart<double>>(geometry, state->grid_values, kernel);
  }
  state_ = std::move(state);
}

PfftSum::~PfftSum() = default;

Index PfftSum::source_count() const { return plan_->geometry().sources.count(); }
Index PfftSum::target_count() const { return plan_->geometry().targets.count(); }

void PfftSum::far_apply(const Eigen::Ref<const MatXcd>& charges,
                        Eigen::Ref<MatXcd> potentials) const {
  FLOE_EXPECT(charges.rows() == source_count() && potentials.rows() == target_count());
  const pfft::Geometry& geometry = plan_->geometry();
  const pfft::Grid& grid = geometry.grid;
  std::vector<Complex> values(static_cast<std::size_t>(grid.nx * grid.ny));
  PaddedGrid::Workspace workspace;
  for (Index column = 0; column < charges.cols(); ++column) {
    pfft::project(grid, geometry.sources, charges.col(column).data(), values.data());
    state_->convolution.apply(values.data(), &workspace);
    pfft::interpolate(grid, geometry.targets, values.data(), potentials.col(column).data());
  }
}

void PfftSum::apply(const Eigen::Ref<const MatXcd>& charges, Eigen::Ref<MatXcd> potentials) const {
  FLOE_VALIDATE(state_->near.index() > 0, "invalid pfft sum = far part only (apply needs all)");
  far_apply(charges, potentials);
  if (const auto* single = std::get_if<pfft::NearPart<float>>(&state_->near))
    single->multiply_add(plan_->geometry(), charges, potentials);
  if (const auto* full = std::get_if<pfft::NearPart<double>>(&state_->near))
    full->multiply_add(plan_->geometry(), charges, potentials);
}

std::vector<Index> PfftSum::near_sources(Index target) const { return plan_->near_sources(target); }

void PfftSum::far_values(Index target, std::span<const Index> sources,
                         std::span<Complex> values) const {
  const pfft::Geometry& geometry = plan_->geometry();
  pfft::Precorrection::Box box(state_->grid_values);
  box.fill(geometry.targets.sorted[target]);
  for (std::size_t k = 0; k < sources.size(); ++k)
    values[k] = box.value(geometry.sources.sorted[sources[k]]);
}

double PfftSum::memory() const {
  double bytes = state_->convolution.memory();
  if (const auto* single = std::get_if<pfft::NearPart<float>>(&state_->near))
    bytes += single->memory();
  if (const auto* full = std::get_if<pfft::NearPart<double>>(&state_->near))
    bytes += full->memory();
  return bytes;
}

}  // namespace floe::fmm
