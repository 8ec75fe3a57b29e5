#include "analysis_stages.hpp"
#include "fluid_cost.hpp"

#include <floe/bem/damped_wave_preconditioner.hpp>
#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/bem/iterative_pressure_operator.hpp>
#include <floe/estimate.hpp>
#include <floe/wave/dispersion.hpp>

#include <algorithm>

namespace floe {
namespace {

// What the engines promise; no result needs more of the operator
constexpr double kLeastGridSum = 1e-7, kLeastBoxSum = 1e-8, kLargestSumTolerance = 1e-2;

// NOTE: sums to 1e-6 would be in single precision, whose rounding alone, 3e-7 of the potentials,
// leaves residuals of up to 3e-6 where potentials cancel; below this tolerance they are in double.
// The grid's error of smooth potentials is a few times below what it is asked for, the boxes' is
// not
constexpr double kDoubleBelow = 5e-6, kGridSumInDouble = 2e-7, kBoxSumInDouble = 5e-8;

// Sums of cheaper steps have their sources at the nodes: accurate ones have 16 points an element
constexpr double kStepSumTolerance = 2e-4;

double sum_tolerance(SolverMethod method, double tolerance) {
  const bool grid = method == SolverMethod::kPfft;
  const double wanted = tolerance < kDoubleBelow
                            ? std::min(tolerance, grid ? kGridSumInDouble : kBoxSumInDouble)
                            : tolerance;
  return std::clamp(wanted, grid ? kLeastGridSum : kLeastBoxSum, kLargestSumTolerance);
}

bem::SumEngine engine_of(SolverMethod method) {
  return method == SolverMethod::kPfft ? bem::SumEngine::kPfft : bem::SumEngine::kMultipole;
}

}  // namespace

FluidOperators prepare_operators(const Case& data, const mesh::Q8Mesh& mesh, double highest) {
  FluidOperators plans;
  plans.method = resolve_method(data, mesh);
  plans.space = plan_krylov(data, mesh);
  if (plans.method == SolverMethod::kLattice)
    plans.lattice = std::make_shared<const bem::LatticePlan>(mesh);
  if (plans.method != SolverMethod::kPfft && plans.method != SolverMethod::kFmm) return plans;
  bem::FastOptions options{.engine = engine_of(plans.method),
                           .tolerance = sum_tolerance(plans.method, data.tolerance),
                           .max_wavenumber = wave::wavenumber(highest, data.water),
                           .memory_budget = plan_budget(data)};
  plans.sums = std::make_shared<const bem::FastPressurePlan>(mesh, options);
  if (has_cheaper_steps(plans.method, data.tolerance)) {
    options.tolerance = kStepSumTolerance;
    plans.step_sums = std::make_shared<const bem::FastPressurePlan>(mesh, options);
  }
  return plans;
}

std::unique_ptr<const krylov::LinearOperator> make_action(const FluidModel& fluid,
                                                          const green::GreenTable& green) {
  const FluidOperators& plans = fluid.operators;
  if (plans.method == SolverMethod::kDense)
    return std::make_unique<const bem::DensePressureOperator>(fluid.integrals, green);
  if (plans.lattice)
    return std::make_unique<const bem::LatticePressureOperator>(plans.lattice, green);
  return std::make_unique<const bem::FastPressureOperator>(plans.sums, green);
}

std::unique_ptr<const krylov::LinearOperator> make_step_action(const FluidModel& fluid,
                                                               const green::GreenTable& green) {
  if (!fluid.operators.step_sums) return nullptr;
  return std::make_unique<const bem::FastPressureOperator>(fluid.operators.step_sums, green);
}

krylov::GmresOptions iteration_options(const Case& data, const FluidModel& fluid) {
  krylov::GmresOptions options;
  options.tolerance = data.tolerance;
  const KrylovPlan& space = fluid.operators.space;
  options.memory = space.memory;
  options.steps_without_restart = space.steps;
  options.max_iterations = space.most_steps;
  options.before_step = fluid.pause;
  if (space.in_float) options.basis = krylov::GmresOptions::Basis::single_precision;
  return options;
}

std::unique_ptr<const bem::PressureOperator> make_operator(const Case& data,
                                                           const FluidModel& fluid,
                                                           const green::GreenTable& green) {
  if (fluid.operators.method == SolverMethod::kDense)
    return std::make_unique<const bem::DensePressureOperator>(fluid.integrals, green);
  const mesh::Q8Mesh& mesh = fluid.integrals.mesh();
  return std::make_unique<const bem::IterativePressureOperator>(
      make_action(fluid, green), make_step_action(fluid, green),
      std::make_unique<const bem::DampedWavePreconditioner>(mesh, green.exact()),
      iteration_options(data, fluid), method_name(fluid.operators.method));
}

}  // namespace floe
