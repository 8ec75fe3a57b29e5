#pragma once

#include <floe/krylov/linear_operator.hpp>
#include <floe/numeric/types.hpp>

#include <functional>
#include <limits>

namespace floe::krylov {

/// A right preconditioner M: A M y = b, x = M y, so that the residual of y is the true one of x.
struct Preconditioner {
  /// A preconditioner that iterates itself is not the same matrix in each application: GMRES must
  /// then keep what it returned.
  enum class Kind { fixed, flexible };

  const LinearOperator* action = nullptr;  ///< view; null: M = I
  Kind kind = Kind::fixed;
};

/// Columns of scratch that a block of the iteration holds beside its directions, a column:
/// residuals, candidates, an image and its copies.
inline constexpr double kScratchColumns = 7.0;

struct GmresOptions {
  double tolerance = 1e-6;     ///< ‖b - Ax‖/‖b‖ asked of each column, 1e-13 … 1
  Index max_iterations = 500;  ///< steps of each block of columns, all cycles together
  /// Memory that the solver may take besides x and b [byte]. It sets how many columns are solved
  /// together and after how many steps the iteration starts again.
  double memory = std::numeric_limits<double>::infinity();
  /// Steps for which a block should have memory; fewer columns are solved together if it has not.
  Index steps_without_restart = 30;
  /// Directions whose part of the residual is smaller than this share of the largest wait for a
  /// later step. (S.4)
  double direction_threshold = 0.1;
  /// Single precision halves the memory and the work of orthogonalisation; what it loses is made
  /// good by a restart.
  enum class Basis { double_precision, single_precision };
  Basis basis = Basis::double_precision;
  /// A cheaper operator near A, which the steps apply in its place (S.8); x is corrected and its
  /// residual computed with A. View; null: A itself.
  const LinearOperator* step_operator = nullptr;
  /// Share of a residual to which the cheaper operator's steps bring it down before A is asked
  /// again; they stop there because the difference of the operators is not much smaller.
  double step_reduction = 1e-3;
  /// Called before each step; what it throws ends the iteration. May be empty.
  std::function<void()> before_step = {};
};

struct GmresReport {
  Index iterations = 0;    ///< steps, summed over blocks
  Index applications = 0;  ///< columns to which A, or the cheaper operator, was applied
  Index checks = 0;        ///< those of them that only recomputed residuals, with A
  Index block_size = 0;    ///< columns solved together
  Index cycles = 0;        ///< 1 a block if nothing was restarted
  VecXd true_residual;  ///< ‖b - Ax‖/‖b‖ of each column by the operator itself; 0 where b = 0
};

/// Solves A X = B by block GMRES with right preconditioning: one Krylov space for all columns of a
/// block (S.2)–(S.4), directions that are dependent, or not needed yet, left out. The residual is
/// recomputed in double precision before it is believed. Same bits for any number of threads.
/// `x` is overwritten. Throws ConvergenceError naming the worst column (from 1) and its residual
/// when the limit of iterations is reached, BudgetError when not even one column fits into the
/// memory, InputError on options out of range.
GmresReport solve_gmres(const LinearOperator& a, const Preconditioner& preconditioner,
                        const Eigen::Ref<const MatXcd>& b, Eigen::Ref<MatXcd> x,
                        const GmresOptions& options = {});

/// The same for one column by Eigen's GMRES: the twin. Of the options it heeds tolerance,
/// max_iterations and steps_without_restart (then it restarts); a flexible preconditioner is
/// refused with InputError.
GmresReport solve_gmres_column(const LinearOperator& a, const Preconditioner& preconditioner,
                               const Eigen::Ref<const VecXcd>& b, Eigen::Ref<VecXcd> x,
                               const GmresOptions& options = {});

}  // namespace floe::krylov
