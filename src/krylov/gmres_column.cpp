#include "krylov/matrix_replacement.hpp"

#include <floe/krylov/gmres.hpp>
#include <floe/numeric/error.hpp>

#include <unsupported/Eigen/IterativeSolvers>

#include <algorithm>

namespace floe::krylov {
namespace {

// A M as one operator. NOTE: Eigen's GMRES preconditions from the left and stops by the
// preconditioned residual; so it is given A M and the identity
class PreconditionedOperator final : public LinearOperator {
 public:
  PreconditionedOperator(const LinearOperator& a, const LinearOperator* m) : a_(a), m_(m) {}

  Index size() const override { return a_.size(); }
  void apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const override {
    if (!m_) return a_.apply(x, y);
    MatXcd z(x.rows(), x.cols());
    m_->apply(x, z);
    a_.apply(z, y);
  }

 private:
  const LinearOperator& a_;  // view
  const LinearOperator* m_;  // view
};

}  // namespace

GmresReport solve_gmres_column(const LinearOperator& a, const Preconditioner& preconditioner,
                               const Eigen::Ref<const VecXcd>& b, Eigen::Ref<VecXcd> x,
                               const GmresOptions& options) {
  FLOE_EXPECT(b.size() == a.size() && x.size() == a.size());
  FLOE_VALIDATE(preconditioner.kind == Preconditioner::Kind::fixed,
                "flexible preconditioner for one column (must be fixed)");
  GmresReport report;
  report.block_size = 1;
  report.true_residual = VecXd::Zero(1);
  x.setZero();
  if (b.norm() == 0.0) return report;

  const PreconditionedOperator preconditioned(a, preconditioner.action);
  Eigen::GMRES<MatrixReplacement, Eigen::IdentityPreconditioner> gmres;
  const MatrixReplacement matrix(preconditioned);
  gmres.compute(matrix);
  gmres.setTolerance(options.tolerance);
  gmres.setMaxIterations(options.max_iterations);
  gmres.set_restart(std::min(options.steps_without_restart, a.size()));
  const VecXcd y = gmres.solve(b);
  report.cycles = 1;
  report.iterations = gmres.iterations();

  // NOTE: Eigen reports success by the recurrence; the residual is made here
  x = y;
  if (preconditioner.action) {
    MatXcd z(a.size(), 1);
    preconditioner.action->apply(y, z);
    x = z.col(0);
  }
  MatXcd image(a.size(), 1);
  a.apply(x, image);
  report.applications = report.iterations + 2;  // of the first guess and the check
  report.true_residual[0] = (b - image.col(0)).norm() / b.norm();
  // What the recurrence may lose to rounding is let pass
  FLOE_VALIDATE_AS(ConvergenceError, report.true_residual[0] <= 1.1 * options.tolerance,
                   "true residual of column 1 = "
                       << report.true_residual[0] << " after " << report.iterations
                       << " iterations (must be at most " << options.tolerance << ")");
  return report;
}

}  // namespace floe::krylov
