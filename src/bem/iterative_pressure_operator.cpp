#include <floe/bem/iterative_pressure_operator.hpp>
#include <floe/numeric/error.hpp>

#include <utility>

namespace floe::bem {

IterativePressureOperator::IterativePressureOperator(
    std::unique_ptr<const krylov::LinearOperator> action,
    std::unique_ptr<const krylov::LinearOperator> step_action,
    std::unique_ptr<const krylov::LinearOperator> preconditioner,
    const krylov::GmresOptions& options, const char* name)
    : action_(std::move(action)),
      step_action_(std::move(step_action)),
      preconditioner_(std::move(preconditioner)),
      options_(options),
      name_(name) {
  options_.step_operator = step_action_.get();
  FLOE_VALIDATE(action_->size() == preconditioner_->size(),
                "invalid preconditioner size = " << preconditioner_->size() << " (must be "
                                                 << action_->size() << ")");
}

SolveReport IterativePressureOperator::solve(Eigen::Ref<MatXcd> rhs) const {
  const MatXcd b = rhs;
  const krylov::GmresReport report =
      krylov::solve_gmres(*action_, {.action = preconditioner_.get()}, b, rhs, options_);
  return {.iterations = report.iterations, .applications = report.applications};
}

}  // namespace floe::bem
