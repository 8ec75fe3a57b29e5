#include "second_try.hpp"

#include "fluid_cost.hpp"

#include <floe/mesh/mesh_quality.hpp>
#include <floe/wave/dispersion.hpp>

#include <fmt/format.h>

#include <numbers>

namespace floe {
namespace {

// Fewer lengthen the iterations: 129 steps with 4.9 nodes a wavelength, 244 with 4.6, more than 500
// with 4.0 (300 × 60 m, elements of 3 m, 30 modes)
constexpr double kNodesEnough = 6.0;

// A factorisation of this many unknowns takes about a quarter of an hour of one core
constexpr Index kMostFactored = 20000;

}  // namespace

std::optional<FluidOperators> second_operators(const Case& data, const FluidModel& fluid) {
  const FluidOperators& planned = fluid.operators;
  const bool modal = data.route == SolverRoute::kModal;
  if (modal && planned.method == SolverMethod::kDense) return std::nullopt;
  const mesh::Q8Mesh& mesh = fluid.integrals.mesh();
  const double free = numeric::memory_budget(data.memory_limit, numeric::memory_limits());
  const double dense = fluid_cost(SolverMethod::kDense, fluid_work(data, mesh)).memory;
  if (modal && mesh.node_count() <= kMostFactored && dense <= plan_budget(data) && dense <= free)
    return FluidOperators{
        .method = SolverMethod::kDense, .lattice = {}, .sums = {}, .step_sums = {}, .space = {}};
  FluidOperators longer = planned;
  longer.step_sums.reset();
  longer.space = longest_krylov(data, mesh);
  if (longer.space.memory > free) return std::nullopt;
  return longer;
}

void throw_at_frequency(const ConvergenceError& error, double omega, const Case& data,
                        const mesh::Q8Mesh& mesh) {
  const double spacing = 0.5 * mesh::longest_edges(mesh).maxCoeff();
  const double nodes = 2.0 * std::numbers::pi / wave::wavenumber(omega, data.water) / spacing;
  const std::string coarse =
      nodes >= kNodesEnough
          ? ""
          : fmt::format("; the mesh has {:.2g} nodes per wavelength (refine it, {:g} are enough)",
                        nodes, kNodesEnough);
  throw ConvergenceError(fmt::format("omega = {} rad/s: {}{}", omega, error.what(), coarse));
}

void tell_second_try(const ConvergenceError& first, double omega, SolverRoute route,
                     SolverMethod method, Log& log) {
  const bool factored = route == SolverRoute::kModal && method == SolverMethod::kDense;
  log.notice(fmt::format("omega = {} rad/s: {}; tried once more {}", omega, first.what(),
                         factored ? "by a dense factorisation" : "with more steps"));
}

}  // namespace floe
