#include <floe/coupling/modal_equation.hpp>
#include <floe/numeric/error.hpp>

#include <Eigen/LU>

namespace floe::coupling {

MatXcd modal_amplitudes(const plate::DryModes& modes, double loss_factor, double omega,
                        const MatXcd& fluid_matrix, const MatXcd& exciting_force) {
  FLOE_EXPECT(fluid_matrix.rows() == modes.count() && exciting_force.rows() == modes.count());
  MatXcd dynamic = -fluid_matrix - omega * omega * modes.modal_mass.cast<Complex>();
  dynamic.diagonal() += Complex(1.0, -loss_factor) * modes.omega.cwiseAbs2().cast<Complex>();

  // NOTE: stiffnesses of the modes span many decades; scaled to a unit diagonal the reciprocal
  // condition number tells a resonance, not the spread
  const VecXd scale = dynamic.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  const MatXcd scaled = scale.asDiagonal() * dynamic * scale.asDiagonal();
  const Eigen::PartialPivLU<MatXcd> factors(scaled);
  const double reciprocal_condition = factors.rcond();
  FLOE_VALIDATE_AS(ConvergenceError, reciprocal_condition > 1e-13,
                   "reciprocal condition of the modal equation at omega = "
                       << omega << " rad/s = " << reciprocal_condition
                       << " (must be above 1e-13: an undamped resonance; set plate.loss_factor)");
  return scale.asDiagonal() * factors.solve(scale.asDiagonal() * exciting_force);
}

double change_by_last_modes(const plate::DryModes& modes, double loss_factor, double omega,
                            const MatXcd& fluid_matrix, const MatXcd& exciting_force,
                            const MatXcd& amplitudes, const Eigen::Ref<const MatXd>& shape) {
  FLOE_EXPECT(amplitudes.rows() == modes.count() && shape.cols() == modes.count());
  const Index left_out = (modes.count() - modes.rigid_count) / 4;
  if (left_out == 0) return 0.0;
  const Index kept = modes.count() - left_out;
  plate::DryModes fewer;
  fewer.omega = modes.omega.head(kept);
  fewer.modal_mass = modes.modal_mass.topLeftCorner(kept, kept);
  MatXcd change = amplitudes;
  change.topRows(kept) -=
      modal_amplitudes(fewer, loss_factor, omega, fluid_matrix.topLeftCorner(kept, kept),
                       exciting_force.topRows(kept));
  const MatXcd motion = shape.cast<Complex>() * amplitudes;
  const double largest = motion.cwiseAbs().maxCoeff();
  if (largest == 0.0) return 0.0;
  return (shape.cast<Complex>() * change).cwiseAbs().maxCoeff() / largest;
}

}  // namespace floe::coupling
