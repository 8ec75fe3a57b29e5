#include "analysis_stages.hpp"

#include <floe/bem/damped_wave_preconditioner.hpp>
#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/bem/iterative_pressure_operator.hpp>
#include <floe/estimate.hpp>
#include <floe/wave/dispersion.hpp>

#include <algorithm>

namespace floe {
namespace {

// The engines promise what they are asked for to 1e-7; no result needs more of the operator
constexpr double kLeastSumTolerance = 1e-7, kLargestSumTolerance = 1e-2;

bem::SumEngine engine_of(SolverMethod method) {
  return method == SolverMethod::kPfft ? bem::SumEngine::kPfft : bem::SumEngine::kMultipole;
}

}  // namespace

FluidOperators prepare_operators(const Case& data, const mesh::Q8Mesh& mesh, double highest) {
  FluidOperators plans{.method = resolve_method(data, mesh), .lattice = {}, .sums = {}};
  if (plans.method == SolverMethod::kLattice)
    plans.lattice = std::make_shared<const bem::LatticePlan>(mesh);
  if (plans.method == SolverMethod::kPfft || plans.method == SolverMethod::kFmm)
    plans.sums = std::make_shared<const bem::FastPressurePlan>(
        mesh, bem::FastOptions{
                  .engine = engine_of(plans.method),
                  .tolerance = std::clamp(data.tolerance, kLeastSumTolerance, kLargestSumTolerance),
                  .max_wavenumber = wave::wavenumber(highest, data.water),
                  .memory_budget = plan_budget(data)});
  return plans;
}

std::unique_ptr<const bem::PressureOperator> make_operator(const Case& data,
                                                           const FluidModel& fluid,
                                                           const green::GreenTable& green) {
  const FluidOperators& plans = fluid.operators;
  if (plans.method == SolverMethod::kDense)
    return std::make_unique<const bem::DensePressureOperator>(fluid.integrals, green);

  std::unique_ptr<const krylov::LinearOperator> action;
  if (plans.lattice)
    action = std::make_unique<const bem::LatticePressureOperator>(plans.lattice, green);
  else
    action = std::make_unique<const bem::FastPressureOperator>(plans.sums, green);
  krylov::GmresOptions options;
  options.tolerance = data.tolerance;
  const KrylovPlan space = plan_krylov(data, fluid.integrals.mesh());
  options.memory = space.memory;
  if (space.in_float) options.basis = krylov::GmresOptions::Basis::single_precision;
  return std::make_unique<const bem::IterativePressureOperator>(
      std::move(action),
      std::make_unique<const bem::DampedWavePreconditioner>(fluid.integrals.mesh(), green.exact()),
      options, method_name(plans.method));
}

}  // namespace floe
