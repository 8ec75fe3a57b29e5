#include <floe/hydro/radiation.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/numeric/error.hpp>
#include <floe/wave/dispersion.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace floe::hydro {
namespace {

struct Checked {
  double residual;  // largest of a column
  bem::SolveReport work;
};

// Solves A X = B and recomputes the residuals; `what` names a column in errors
Checked solve_checked(const bem::PressureOperator& pressure_operator, MatXcd& x, const char* what,
                      double residual_limit) {
  const MatXcd rhs = x;
  bem::SolveReport work = pressure_operator.solve(x);
  MatXcd image(x.rows(), x.cols());
  pressure_operator.apply(x, image);
  double worst = 0.0;
  for (Index j = 0; j < x.cols(); ++j) {
    const double residual = (image.col(j) - rhs.col(j)).norm() / rhs.col(j).norm();
    FLOE_VALIDATE_AS(ConvergenceError, residual <= residual_limit,
                     "true residual of " << what << " " << j + 1 << " = " << residual
                                         << " (must be at most " << residual_limit << ")");
    worst = std::max(worst, residual);
  }
  work.applications += x.cols();
  return {worst, work};
}

}  // namespace

Radiation solve_radiation(const bem::PressureOperator& pressure_operator,
                          const Eigen::Ref<const MatXd>& deflection,
                          const SparseMatrix& surface_mass, double omega, const wave::Water& water,
                          double residual_limit) {
  const double weight = water.density * water.gravity;
  Radiation result;
  result.pressure = -weight * deflection.cast<Complex>();
  const Checked solved =
      solve_checked(pressure_operator, result.pressure, "radiation mode", residual_limit);
  result.true_residual = solved.residual;
  result.work = solved.work;

  // Project on the modes, then take the hydrostatic part out
  const MatXd weighted = surface_mass * deflection;
  result.fluid_matrix = weighted.transpose().cast<Complex>() * result.pressure;
  const MatXcd hydrodynamic =
      result.fluid_matrix + (weight * (weighted.transpose() * deflection)).cast<Complex>();
  result.added_mass = hydrodynamic.real() / (omega * omega);
  result.damping = hydrodynamic.imag() / omega;
  return result;
}

MatXcd solve_diffraction(const bem::PressureOperator& pressure_operator,
                         const Eigen::Ref<const MatXcd>& elevation, const wave::Water& water,
                         double residual_limit) {
  MatXcd pressure = water.density * water.gravity * elevation;
  solve_checked(pressure_operator, pressure, "wave heading", residual_limit);
  return pressure;
}

MatXcd exciting_forces(const MatXcd& radiation_pressure, const MatXcd& wave_loads) {
  return -(radiation_pressure.transpose() * wave_loads);
}

MatXcd exciting_forces_direct(const Eigen::Ref<const MatXd>& deflection,
                              const SparseMatrix& surface_mass, const MatXcd& wave_pressure) {
  const MatXd weighted = surface_mass * deflection;
  return weighted.transpose().cast<Complex>() * wave_pressure;
}

MatXcd froude_krylov_forces(const Eigen::Ref<const MatXd>& deflection, const MatXcd& wave_loads,
                            const wave::Water& water) {
  // Heading by heading: a complex copy of all deflections would be as large as the solution
  const double weight = water.density * water.gravity;
  MatXcd force(deflection.cols(), wave_loads.cols());
  for (Index b = 0; b < wave_loads.cols(); ++b) {
    const VecXd real = wave_loads.col(b).real(), imaginary = wave_loads.col(b).imag();
    force.col(b).real() = weight * (deflection.transpose() * real);
    force.col(b).imag() = weight * (deflection.transpose() * imaginary);
  }
  return force;
}

MatXd radiated_damping(const Eigen::Ref<const MatXcd>& radiation_pressure, const mesh::Q8Mesh& mesh,
                       double omega, const wave::Water& water) {
  const double k = wave::wavenumber(omega, water);
  const double half_diagonal = 0.5 * (mesh.upper() - mesh.lower()).norm();
  const int headings = 20 + 2 * static_cast<int>(std::ceil(k * half_diagonal));
  const MatXcd force = -full_circle_transform(mesh, k, headings, radiation_pressure);
  const double factor = k / (8.0 * std::numbers::pi * water.density * water.gravity *
                             wave::group_velocity(omega, water));
  return factor * 2.0 * std::numbers::pi / headings * (force * force.adjoint()).real();
}

double energy_error(const Radiation& radiation, const MatXd& radiated, double omega) {
  const VecXd scale = radiation.damping.diagonal().cwiseAbs().cwiseMax(
      omega * radiation.added_mass.diagonal().cwiseAbs());
  double worst = 0.0;
  for (Index i = 0; i < scale.size(); ++i)
    for (Index j = 0; j < scale.size(); ++j)
      worst = std::max(worst, std::abs(radiation.damping(i, j) - radiated(i, j)) /
                                  std::sqrt(scale[i] * scale[j]));
  return worst;
}

double passivity_error(const Radiation& radiation) {
  if (!radiation.damping.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  const MatXd symmetric = 0.5 * (radiation.damping + radiation.damping.transpose());
  const VecXd values =
      Eigen::SelfAdjointEigenSolver<MatXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
  const double largest = values.cwiseAbs().maxCoeff();
  return largest > 0.0 ? std::max(0.0, -values.minCoeff()) / largest : 0.0;
}

double reciprocity_error(const Radiation& radiation, double omega) {
  const MatXcd hydrodynamic =
      omega * omega * radiation.added_mass + Complex(0.0, omega) * radiation.damping;
  return (hydrodynamic - hydrodynamic.transpose()).norm() / hydrodynamic.norm();
}

}  // namespace floe::hydro
