#include <floe/hydro/point_pressure.hpp>
#include <floe/hydro/radiation.hpp>
#include <floe/numeric/error.hpp>

#include <Eigen/IterativeLinearSolvers>

#include <numbers>

namespace floe::hydro {
namespace {

// Nodal values of the fields whose integrals against the N_m are given: S⁻¹ times them
MatXcd best_fit(const SparseMatrix& surface_mass, const MatXcd& integrals) {
  // NOTE: scaled by its diagonal, the mass of Q8 elements has a condition number of some ten
  // whatever the mesh: a few dozen steps
  Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper> solver(surface_mass);
  solver.setTolerance(1e-13);
  MatXcd values(integrals.rows(), integrals.cols());
  for (Index j = 0; j < integrals.cols(); ++j) {
    const VecXd real = integrals.col(j).real(), imaginary = integrals.col(j).imag();
    values.col(j).real() = solver.solve(real);
    FLOE_VALIDATE_AS(ConvergenceError, solver.info() == Eigen::Success,
                     "the surface mass is not solved for point " << j + 1);
    values.col(j).imag() = solver.solve(imaginary);
    FLOE_VALIDATE_AS(ConvergenceError, solver.info() == Eigen::Success,
                     "the surface mass is not solved for point " << j + 1);
  }
  return values;
}

}  // namespace

MatXcd wave_pressure_influence(const bem::PressureOperator& pressure_operator,
                               const bem::ElementIntegrals& integrals,
                               const green::GreenTable& green, const SparseMatrix& surface_mass,
                               const Points2& points, const wave::Water& water,
                               double residual_limit) {
  const double kappa = green.exact().nu() / (4.0 * std::numbers::pi);
  MatXcd kernel(surface_mass.rows(), points.cols());
#pragma omp parallel for schedule(dynamic, 1)
  for (Index i = 0; i < points.cols(); ++i) {
    VecXcd row(kernel.rows());
    integrals.point_row(points.col(i), green, row);
    kernel.col(i) = kappa * row;
  }
  return solve_diffraction(pressure_operator, best_fit(surface_mass, kernel), water,
                           residual_limit);
}

}  // namespace floe::hydro
