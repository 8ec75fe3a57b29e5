#include "krylov/block_krylov.hpp"

#include <floe/krylov/gmres.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace floe::krylov {
namespace {

// The recurrence goes on until its residual is this share of the tolerance, for the true one
// differs by rounding
constexpr double kSafety = 0.9;
// A cycle that leaves more than this of a residual has stagnated
constexpr double kStagnation = 0.99;

// How many columns are solved together, and how many directions they may have
struct Plan {
  Index columns = 1;
  Index directions = 0;
};

Plan plan_memory(Index n, Index columns, const Preconditioner& preconditioner,
                 const GmresOptions& options) {
  const double row = 16.0 * static_cast<double>(n);
  const bool single = options.basis == GmresOptions::Basis::single_precision;
  const bool flexible = preconditioner.kind == Preconditioner::Kind::flexible;
  const double direction = row * (single ? 0.5 : 1.0) * (flexible ? 2.0 : 1.0);
  // Residuals, candidates, an image and its copies besides the basis
  const double column = 7.0 * row;
  const auto directions = [&](Index block) {
    return (options.memory - column * static_cast<double>(block)) / direction;
  };
  Plan plan;
  plan.columns = std::max<Index>(columns, 1);
  while (plan.columns > 1 &&
         directions(plan.columns) < double(plan.columns * options.steps_without_restart))
    --plan.columns;
  // Blocks of about equal size
  const Index blocks = (std::max<Index>(columns, 1) + plan.columns - 1) / plan.columns;
  plan.columns = (std::max<Index>(columns, 1) + blocks - 1) / blocks;
  const double most = directions(plan.columns);
  FLOE_VALIDATE_AS(BudgetError, most >= 2.0,
                   "memory for the iterative solver = "
                       << options.memory << " byte (must be at least " << column + 2.0 * direction
                       << " for " << n << " unknowns)");
  plan.directions = most < 1e9 ? static_cast<Index>(most) : Index{1000000000};
  return plan;
}

// One block of columns; `first` is the number of its first column for messages
class BlockSolve {
 public:
  BlockSolve(const LinearOperator& a, const Preconditioner& preconditioner,
             const GmresOptions& options, Index directions, GmresReport& report)
      : a_(a),
        preconditioner_(preconditioner),
        options_(options),
        directions_(directions),
        report_(report) {}

  // Returns the true residuals
  VecXd solve(const Eigen::Ref<const MatXcd>& b, Eigen::Ref<MatXcd> x, Index first) {
    const VecXd scale = column_norms(b);
    FLOE_VALIDATE_AS(ConvergenceError, scale.allFinite(),
                     "right-hand side of columns " << first + 1 << " … " << first + b.cols()
                                                   << " is not finite");
    x.setZero();
    MatXcd residual = b;
    VecXd norm = (scale.array() > 0.0).cast<double>();
    Index steps = 0;
    while (true) {
      std::vector<Index> open;
      for (Index j = 0; j < b.cols(); ++j)
        if (!(norm[j] <= options_.tolerance)) open.push_back(j);
      if (open.empty()) return norm;
      const VecXd before = norm;
      steps += correct(open, scale, residual, x, options_.max_iterations - steps);
      check_residuals(open, b, scale, x, residual, norm);
      require_progress(open, before, norm, steps, first);
    }
  }

 private:
  // Runs a cycle for the open columns and corrects x; returns the number of steps
  Index correct(const std::vector<Index>& open, const VecXd& scale, const MatXcd& residual,
                Eigen::Ref<MatXcd> x, Index steps) {
    MatXcd scaled(residual.rows(), static_cast<Index>(open.size()));
    VecXd unit(scaled.cols());
    for (Index i = 0; i < scaled.cols(); ++i) {
      const Index j = open[static_cast<std::size_t>(i)];
      unit[i] = kSafety * options_.tolerance * scale[j];
      scaled.col(i) = residual.col(j) / unit[i];
    }
    ++report_.cycles;
    return options_.basis == GmresOptions::Basis::single_precision
               ? cycle<std::complex<float>>(open, unit, std::move(scaled), x, steps)
               : cycle<Complex>(open, unit, std::move(scaled), x, steps);
  }

  template <class Scalar>
  Index cycle(const std::vector<Index>& open, const VecXd& unit, MatXcd scaled,
              Eigen::Ref<MatXcd> x, Index steps) {
    const bool flexible = preconditioner_.kind == Preconditioner::Kind::flexible;
    BlockKrylov<Scalar> krylov(std::move(scaled));
    std::vector<Tall<Scalar>> kept;
    Index step = 0;
    for (; step < steps; ++step) {
      const MatXcd chosen =
          krylov.choose(options_.direction_threshold, directions_ - krylov.expanded());
      if (chosen.cols() == 0) break;
      const MatXcd preconditioned = precondition(chosen);
      MatXcd image(chosen.rows(), chosen.cols());
      a_.apply(preconditioned, image);
      report_.applications += chosen.cols();
      krylov.expand(chosen, std::move(image));
      if (flexible) kept.push_back(preconditioned.cast<Scalar>());
    }
    const MatXcd correction =
        flexible ? krylov.combine(kept) : precondition(krylov.combine(krylov.blocks()));
    for (Index i = 0; i < correction.cols(); ++i)
      x.col(open[static_cast<std::size_t>(i)]) += unit[i] * correction.col(i);
    report_.iterations += step;
    return step;
  }

  MatXcd precondition(const MatXcd& y) const {
    if (!preconditioner_.action) return y;
    MatXcd z(y.rows(), y.cols());
    preconditioner_.action->apply(y, z);
    return z;
  }

  // True residuals of the open columns
  void check_residuals(const std::vector<Index>& open, const Eigen::Ref<const MatXcd>& b,
                       const VecXd& scale, const Eigen::Ref<const MatXcd>& x, MatXcd& residual,
                       VecXd& norm) {
    MatXcd solution(x.rows(), static_cast<Index>(open.size())), image(x.rows(), solution.cols());
    for (Index i = 0; i < solution.cols(); ++i)
      solution.col(i) = x.col(open[static_cast<std::size_t>(i)]);
    a_.apply(solution, image);
    report_.applications += solution.cols();
    for (Index i = 0; i < solution.cols(); ++i) {
      const Index j = open[static_cast<std::size_t>(i)];
      residual.col(j) = b.col(j) - image.col(i);
      norm[j] = residual.col(j).norm() / scale[j];
    }
  }

  void require_progress(const std::vector<Index>& open, const VecXd& before, const VecXd& norm,
                        Index steps, Index first) const {
    Index worst = open.front();
    bool progress = false;
    for (const Index j : open) {
      if (!(norm[j] <= norm[worst])) worst = j;
      progress = progress || norm[j] <= kStagnation * before[j];
    }
    if (norm[worst] <= options_.tolerance) return;
    const bool finite = norm.allFinite();
    FLOE_VALIDATE_AS(ConvergenceError, finite && progress && steps < options_.max_iterations,
                     "true residual of column "
                         << first + worst + 1 << " = " << norm[worst] << " after " << steps
                         << " iterations"
                         << (finite && steps < options_.max_iterations ? ", stagnating" : "")
                         << " (must be at most " << options_.tolerance << ")");
  }

  const LinearOperator& a_;               // view
  const Preconditioner& preconditioner_;  // view
  const GmresOptions& options_;           // view
  Index directions_;
  GmresReport& report_;  // view
};

void check_options(const GmresOptions& options) {
  FLOE_VALIDATE(options.tolerance >= 1e-13 && options.tolerance <= 1.0,
                "invalid tolerance of the iterative solver = " << options.tolerance
                                                               << " (must be between 1e-13 and 1)");
  FLOE_VALIDATE(options.max_iterations > 0, "invalid limit of iterations = "
                                                << options.max_iterations << " (must be positive)");
  FLOE_VALIDATE(
      options.steps_without_restart > 0,
      "invalid steps without restart = " << options.steps_without_restart << " (must be positive)");
  FLOE_VALIDATE(
      options.direction_threshold >= 0.0 && options.direction_threshold < 1.0,
      "invalid threshold of directions = " << options.direction_threshold << " (must be 0 … 1)");
}

}  // namespace

GmresReport solve_gmres(const LinearOperator& a, const Preconditioner& preconditioner,
                        const Eigen::Ref<const MatXcd>& b, Eigen::Ref<MatXcd> x,
                        const GmresOptions& options) {
  FLOE_EXPECT(b.rows() == a.size() && x.rows() == a.size() && x.cols() == b.cols());
  check_options(options);
  const Plan plan = plan_memory(b.rows(), b.cols(), preconditioner, options);
  GmresReport report;
  report.block_size = plan.columns;
  report.true_residual = VecXd::Zero(b.cols());
  BlockSolve block(a, preconditioner, options, plan.directions, report);
  for (Index first = 0; first < b.cols(); first += plan.columns) {
    const Index count = std::min(plan.columns, b.cols() - first);
    report.true_residual.segment(first, count) =
        block.solve(b.middleCols(first, count), x.middleCols(first, count), first);
  }
  return report;
}

}  // namespace floe::krylov
