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
  const double column = kScratchColumns * row;
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

// Solves one block of columns; `first` is the number of its first column, for messages
class BlockSolve {
 public:
  BlockSolve(const LinearOperator& a, const Preconditioner& preconditioner,
             const GmresOptions& options, Index directions, Index first, GmresReport& report)
      : a_(a),
        preconditioner_(preconditioner),
        options_(options),
        directions_(directions),
        first_(first),
        report_(report) {}

  // Returns the true residuals
  VecXd solve(const Eigen::Ref<const MatXcd>& b, Eigen::Ref<MatXcd> x) {
    const VecXd norms = column_norms(b);
    FLOE_VALIDATE_AS(ConvergenceError, norms.allFinite(),
                     "right-hand side of columns " << first_ + 1 << " … " << first_ + b.cols()
                                                   << " is not finite");
    x.setZero();
    preconditioned_.resize(b.rows(), preconditioner_.action ? b.cols() : 0);
    image_.resize(b.rows(), b.cols());
    State state{x, b, norms, (norms.array() > 0.0).cast<double>(), VecXd::Zero(b.cols())};
    while (!open_columns(state).empty()) {
      const VecXd before = state.relative;
      const bool cheaper = cheaper_steps_;
      if (options_.basis == GmresOptions::Basis::single_precision)
        run_cycle<std::complex<float>>(b, state);
      else
        run_cycle<Complex>(b, state);
      if (cheaper == cheaper_steps_) require_progress(before, state);
    }
    return state.relative;
  }

 private:
  struct State {
    Eigen::Ref<MatXcd> x;
    MatXcd residual;  // true ones
    VecXd scale;      // ‖b‖
    VecXd relative;   // ‖residual‖/‖b‖
    VecXd unit;       // norm that the recurrence is to reach
  };

  std::vector<Index> open_columns(const State& state) const {
    std::vector<Index> open;
    for (Index j = 0; j < state.relative.size(); ++j)
      if (!(state.relative[j] <= options_.tolerance)) open.push_back(j);
    return open;
  }

  // Writes the residuals to image_ in units of what the recurrence is to reach: the tolerance, or
  // as far as the cheaper operator is worth following
  Eigen::Ref<MatXcd> scaled_residual(State& state, const std::vector<Index>& open) {
    const double reduction = cheaper_steps_ ? options_.step_reduction : 0.0;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const Index j = open[i];
      state.unit[j] =
          kSafety * std::max(options_.tolerance, reduction * state.relative[j]) * state.scale[j];
      image_.col(static_cast<Index>(i)) = state.residual.col(j) / state.unit[j];
    }
    return image_.leftCols(static_cast<Index>(open.size()));
  }

  // Builds one Krylov space until the columns have converged or the memory is full. When the
  // recurrence has converged but the true residuals have not, the space goes on with these. A
  // cheaper operator that does not bring them down is given up
  template <class Scalar>
  void run_cycle(const Eigen::Ref<const MatXcd>& b, State& state) {
    ++report_.cycles;
    std::vector<Index> open = open_columns(state);
    BlockKrylov<Scalar> krylov(b.rows());
    krylov.replace_residual(scaled_residual(state, open));
    std::vector<Tall<Scalar>> kept;
    while (true) {
      const VecXd before = state.relative;
      const bool full = grow(krylov, kept);
      correct(krylov, kept, open, b, state);
      open = open_columns(state);
      const bool progress = (state.relative.array() < 0.5 * before.array()).any();
      if (!progress && !full) cheaper_steps_ = false;
      if (open.empty() || full || !progress || steps_ == options_.max_iterations) return;
      krylov.replace_residual(scaled_residual(state, open));
    }
  }

  // Steps until the recurrence has converged (false) or there is no memory for more (true)
  template <class Scalar>
  bool grow(BlockKrylov<Scalar>& krylov, std::vector<Tall<Scalar>>& kept) {
    for (; steps_ < options_.max_iterations; ++steps_, ++report_.iterations) {
      if (options_.before_step) options_.before_step();
      const Index room = directions_ - krylov.expanded();
      if (room <= 0) return true;
      const Index count =
          krylov.choose(options_.direction_threshold, std::min(room, image_.cols()));
      if (count == 0) return false;
      const auto direction = preconditioned(krylov.chosen(count));
      auto image = image_.leftCols(count);
      (cheaper_steps_ ? *options_.step_operator : a_).apply(direction, image);
      report_.applications += count;
      if (flexible()) kept.push_back(stored<Scalar>(direction));
      krylov.expand(image);
    }
    return true;
  }

  // Corrects x and recomputes the residuals of the open columns
  template <class Scalar>
  void correct(const BlockKrylov<Scalar>& krylov, const std::vector<Tall<Scalar>>& kept,
               const std::vector<Index>& open, const Eigen::Ref<const MatXcd>& b, State& state) {
    if (krylov.expanded() == 0) return;
    const auto count = static_cast<Index>(open.size());
    MatXcd correction(b.rows(), count);
    auto image = image_.leftCols(count);
    krylov.combine(flexible() ? kept : krylov.blocks(), correction);
    if (!flexible() && preconditioner_.action) correction = preconditioned(correction);
    for (std::size_t i = 0; i < open.size(); ++i) {
      state.x.col(open[i]) += state.unit[open[i]] * correction.col(static_cast<Index>(i));
      correction.col(static_cast<Index>(i)) = state.x.col(open[i]);
    }
    a_.apply(correction, image);
    report_.applications += correction.cols();
    report_.checks += correction.cols();
    for (std::size_t i = 0; i < open.size(); ++i) {
      const Index j = open[i];
      state.residual.col(j) = b.col(j) - image.col(static_cast<Index>(i));
      state.relative[j] = state.residual.col(j).norm() / state.scale[j];
    }
  }

  bool flexible() const { return preconditioner_.kind == Preconditioner::Kind::flexible; }

  // y itself where there is no preconditioner, else in preconditioned_
  Eigen::Ref<const MatXcd> preconditioned(const Eigen::Ref<const MatXcd>& y) {
    if (!preconditioner_.action) return y;
    auto z = preconditioned_.leftCols(y.cols());
    preconditioner_.action->apply(y, z);
    return z;
  }

  // Throws unless all columns have converged, or some have come nearer and there are steps left
  void require_progress(const VecXd& before, const State& state) const {
    const std::vector<Index> open = open_columns(state);
    if (open.empty()) return;
    Index worst = open.front();
    bool progress = false;
    for (const Index j : open) {
      if (!(state.relative[j] <= state.relative[worst])) worst = j;
      progress = progress || state.relative[j] <= kStagnation * before[j];
    }
    const bool stagnates = steps_ < options_.max_iterations;
    FLOE_VALIDATE_AS(ConvergenceError, state.relative.allFinite() && progress && stagnates,
                     "true residual of column "
                         << first_ + worst + 1 << " = " << state.relative[worst] << " after "
                         << steps_ << " iterations" << (stagnates ? ", stagnating" : "")
                         << " (must be at most " << options_.tolerance << ")");
  }

  const LinearOperator& a_;               // view
  const Preconditioner& preconditioner_;  // view
  const GmresOptions& options_;           // view
  Index directions_;
  Index first_;
  GmresReport& report_;            // view
  MatXcd preconditioned_, image_;  // memory that is asked for once, not at every step
  Index steps_ = 0;
  bool cheaper_steps_ = options_.step_operator != nullptr;
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
  FLOE_VALIDATE(options.step_reduction > 0.0 && options.step_reduction < 1.0,
                "invalid reduction by the cheaper operator = " << options.step_reduction
                                                               << " (must be between 0 and 1)");
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
  for (Index first = 0; first < b.cols(); first += plan.columns) {
    const Index count = std::min(plan.columns, b.cols() - first);
    BlockSolve block(a, preconditioner, options, plan.directions, first, report);
    report.true_residual.segment(first, count) =
        block.solve(b.middleCols(first, count), x.middleCols(first, count));
  }
  return report;
}

}  // namespace floe::krylov
