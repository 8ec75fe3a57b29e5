#pragma once

#include <floe/bem/pressure_operator.hpp>
#include <floe/krylov/gmres.hpp>

#include <memory>

namespace floe::bem {

/// I + κ𝒢 behind any fast operator, solved by preconditioned block GMRES to a residual.
class IterativePressureOperator final : public PressureOperator {
 public:
  /// `action` is I + κ𝒢, `step_action` the same less accurately for the steps (null: `action`),
  /// `preconditioner` an approximation of its inverse; `name` is what method() tells. Throws
  /// InputError when their sizes differ.
  IterativePressureOperator(std::unique_ptr<const krylov::LinearOperator> action,
                            std::unique_ptr<const krylov::LinearOperator> step_action,
                            std::unique_ptr<const krylov::LinearOperator> preconditioner,
                            const krylov::GmresOptions& options, const char* name);

  Index size() const override { return action_->size(); }
  void apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const override {
    action_->apply(x, y);
  }
  /// Throws ConvergenceError naming the worst column when the residual asked is not reached.
  SolveReport solve(Eigen::Ref<MatXcd> rhs) const override;
  const char* method() const override { return name_; }

 private:
  std::unique_ptr<const krylov::LinearOperator> action_, step_action_, preconditioner_;
  krylov::GmresOptions options_;
  const char* name_;
};

}  // namespace floe::bem
