#include "solution_checks.hpp"

#include <floe/bem/residual_between_nodes.hpp>
#include <floe/bem/sampled_residual.hpp>
#include <floe/coupling/modal_equation.hpp>

namespace floe {

void judge_radiation(const Case& data, const FluidModel& fluid, const green::GreenTable& green,
                     const hydro::Radiation& radiation, const Eigen::Ref<const MatXcd>& pressure,
                     FrequencyReport& report) {
  report.iterations = static_cast<int>(radiation.work.iterations);
  report.applications = radiation.work.applications;
  report.true_residual = radiation.true_residual;
  report.kernel_error = green.sampled_error(200);
  report.reciprocity_error = hydro::reciprocity_error(radiation, report.omega);
  report.energy_error = hydro::energy_error(
      radiation,
      hydro::radiated_damping(pressure, fluid.integrals.mesh(), report.omega, data.water),
      report.omega);
  report.passivity_error = hydro::passivity_error(radiation);
  const MatXcd known = -data.water.density * data.water.gravity * fluid.deflection.cast<Complex>();
  report.exact_residual = fluid.operators.method == SolverMethod::kDense  // the exact operator
                              ? radiation.true_residual
                              : bem::sampled_residual(fluid.integrals, green, pressure, known);
  report.residual_between_nodes =
      bem::residual_between_nodes(fluid.integrals, green, pressure, known);
}

double change_by_modes(const Case& data, const PlateModel& plate, const FluidModel& fluid,
                       double omega, const MatXcd& fluid_matrix, const MatXcd& exciting_force,
                       const MatXcd& amplitudes) {
  constexpr Index kNodes = 2000;
  const Index stride = 1 + fluid.deflection.rows() / kNodes;
  const MatXd shape = fluid.deflection(
      Eigen::seqN(Index{0}, (fluid.deflection.rows() + stride - 1) / stride, stride), Eigen::all);
  return coupling::change_by_last_modes(plate.modes, data.plate.loss_factor, omega, fluid_matrix,
                                        exciting_force, amplitudes, shape);
}

}  // namespace floe
