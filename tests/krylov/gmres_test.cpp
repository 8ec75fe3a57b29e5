#include <floe/krylov/gmres.hpp>
#include <floe/numeric/error.hpp>

#include <Eigen/LU>
#include <expect.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <limits>
#include <string>

namespace floe::krylov {
namespace {

using Basis = GmresOptions::Basis;

class MatrixOperator final : public LinearOperator {
 public:
  explicit MatrixOperator(MatXcd matrix) : matrix_(std::move(matrix)) {}
  Index size() const override { return matrix_.rows(); }
  void apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const override {
    y.noalias() = matrix_ * x;
  }
  const MatXcd& matrix() const { return matrix_; }

 private:
  MatXcd matrix_;
};

// Entries in [-1, 1] + i[-1, 1], the same on every machine
MatXcd noise(Index rows, Index columns, unsigned seed) {
  std::uint64_t state = seed + 1;
  const auto next = [&state] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return 2.0 * double(state >> 33) / double(std::uint64_t{1} << 31) - 1.0;
  };
  MatXcd value(rows, columns);
  for (Index j = 0; j < columns; ++j)
    for (Index i = 0; i < rows; ++i) {
      const double re = next();
      value(i, j) = Complex(re, next());
    }
  return value;
}

// I + noise of norm about `strength`: eigenvalues in a disc around 1
MatXcd second_kind(Index n, double strength) {
  return MatXcd::Identity(n, n) + strength / std::sqrt(2.0 / 3.0 * double(n)) * noise(n, n, 7);
}

// Diagonal with eigenvalues on an arc, coupled to neighbours: large and cheap
class Chain final : public LinearOperator {
 public:
  explicit Chain(Index n) : n_(n) {}
  Index size() const override { return n_; }
  void apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const override {
    for (Index j = 0; j < x.cols(); ++j)
      for (Index i = 0; i < n_; ++i) {
        y(i, j) = std::polar(2.0, 1.2 * double(i) / double(n_)) * x(i, j);
        if (i > 0) y(i, j) += 0.3 * x(i - 1, j);
        if (i + 1 < n_) y(i, j) -= 0.2 * x(i + 1, j);
      }
  }

 private:
  Index n_;
};

double worst_residual(const MatXcd& a, const MatXcd& b, const MatXcd& x) {
  const MatXcd residual = b - a * x;
  double worst = 0.0;
  for (Index j = 0; j < b.cols(); ++j)
    if (b.col(j).norm() > 0.0) worst = std::max(worst, residual.col(j).norm() / b.col(j).norm());
  return worst;
}

TEST(twin_Gmres, SolvesAsTheDenseFactorsDoToTheToleranceAsked) {
  const MatrixOperator a(second_kind(150, 0.6));
  const MatXcd b = noise(150, 7, 1);
  const MatXcd expected = a.matrix().partialPivLu().solve(b);
  // |x - x*| ≤ |A⁻¹| |b - Ax|, and |b| ≤ |A| |x*|
  const double condition = 1.0 / a.matrix().partialPivLu().rcond();
  for (const Basis basis : {Basis::double_precision, Basis::single_precision})
    for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
      MatXcd x(150, 7);
      const GmresReport report = solve_gmres(a, {}, b, x, {.tolerance = tolerance, .basis = basis});
      EXPECT_LE(report.true_residual.maxCoeff(), tolerance);
      EXPECT_LE(worst_residual(a.matrix(), b, x), 1.001 * tolerance + 1e-15);
      EXPECT_LE(test::relative_error(x, expected), condition * tolerance);
    }
}

TEST(twin_Gmres, OneColumnTakesAsManyStepsAsEigensGmres) {
  const MatrixOperator a(second_kind(150, 0.6)), m(second_kind(150, 0.3).inverse());
  const MatXcd b = noise(150, 1, 2);
  for (const LinearOperator* action :
       {static_cast<const LinearOperator*>(nullptr), static_cast<const LinearOperator*>(&m)}) {
    MatXcd ours(150, 1);
    VecXcd twin(150);
    const GmresOptions options{.tolerance = 1e-9, .steps_without_restart = 150};
    const GmresReport block = solve_gmres(a, {.action = action}, b, ours, options);
    const GmresReport column = solve_gmres_column(a, {.action = action}, b.col(0), twin, options);
    EXPECT_LE(std::abs(block.iterations - column.iterations), 1);  // we keep 10 % in hand
    EXPECT_LE(column.true_residual[0], 1.1e-9);
    EXPECT_LE(test::relative_error(ours.col(0), twin), 1e-7);
  }
}

TEST(Gmres, NeedsFewerApplicationsForManyColumnsThanForEachAlone) {
  const Chain a(400);
  const MatXcd b = noise(400, 12, 3);
  MatXcd x(400, 12);
  const GmresReport together = solve_gmres(a, {}, b, x, {.tolerance = 1e-8});
  Index alone = 0;
  for (Index j = 0; j < 12; ++j)
    alone += solve_gmres(a, {}, b.col(j), x.col(j), {.tolerance = 1e-8}).applications;
  EXPECT_LT(together.applications, alone);
}

TEST(Gmres, CheaperStepsLeaveTheTrueResidualOfTheOperatorItself) {
  // Errors of 1e-5 to 1e-2 of the operator's size in what the steps see
  const MatrixOperator a(second_kind(150, 0.6));
  const MatXcd b = noise(150, 7, 1);
  for (const double error : {1e-5, 1e-3, 1e-2}) {
    const MatrixOperator cheaper(a.matrix() + error / std::sqrt(100.0) * noise(150, 150, 8));
    MatXcd x(150, 7), exact(150, 7);
    GmresOptions options{.tolerance = 1e-9, .step_reduction = 3.0 * error};
    const GmresReport twin = solve_gmres(a, {}, b, exact, options);
    options.step_operator = &cheaper;
    const GmresReport report = solve_gmres(a, {}, b, x, options);
    EXPECT_LE(worst_residual(a.matrix(), b, x), 1e-9) << error;
    EXPECT_LE(report.true_residual.maxCoeff(), 1e-9);
    EXPECT_GT(report.checks, twin.checks) << "A cannot have been asked often enough";
    // The cheaper operator's work is all but that of the checks
    EXPECT_LE(report.applications - report.checks, 2 * twin.applications) << error;
  }
}

TEST(Gmres, CheaperStepsThatLeadNowhereAreGivenUp) {
  const MatrixOperator a(second_kind(80, 0.4)), other(MatXcd(-second_kind(80, 0.4)));
  const MatXcd b = noise(80, 3, 5);
  MatXcd x(80, 3);
  const GmresReport report = solve_gmres(a, {}, b, x, {.tolerance = 1e-8, .step_operator = &other});
  EXPECT_LE(worst_residual(a.matrix(), b, x), 1e-8);
  EXPECT_GE(report.cycles, 2);
}

TEST(Gmres, RightPreconditioningLeavesTheTrueResidual) {
  // A preconditioner that is badly scaled would fool a left-preconditioned iteration
  const Index n = 80;
  MatXcd a = second_kind(n, 0.4), m = MatXcd::Identity(n, n);
  for (Index i = 0; i < n; ++i) m(i, i) = std::pow(10.0, -double(i % 4));
  const MatrixOperator matrix(a * m.inverse()), preconditioner(m);
  const MatXcd b = noise(n, 4, 4);
  MatXcd x(n, 4);
  const GmresReport report =
      solve_gmres(matrix, {.action = &preconditioner}, b, x, {.tolerance = 1e-9});
  EXPECT_LE(worst_residual(matrix.matrix(), b, x), 1e-9);
  EXPECT_LE(report.iterations, 30);
}

TEST(Gmres, KeepsWhatAFlexiblePreconditionerReturned) {
  // Another matrix in each application
  class Changing final : public LinearOperator {
   public:
    explicit Changing(const MatXcd& inverse) : inverse_(inverse) {}
    Index size() const override { return inverse_.rows(); }
    void apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const override {
      y = inverse_ * x;
      for (Index j = 0; j < y.cols(); ++j)
        y.col(j) *= 1.0 + 0.2 * std::sin(1e3 * std::abs(x(3, j)));
    }

   private:
    MatXcd inverse_;
  };
  const MatrixOperator a(second_kind(100, 0.7));
  const Changing m(a.matrix().inverse());
  const MatXcd b = noise(100, 5, 5);
  MatXcd x(100, 5);
  const GmresReport report = solve_gmres(a, {.action = &m, .kind = Preconditioner::Kind::flexible},
                                         b, x, {.tolerance = 1e-9});
  EXPECT_EQ(report.cycles, 1);
  EXPECT_LE(report.iterations, 3);
  EXPECT_LE(worst_residual(a.matrix(), b, x), 1e-9);
}

TEST(Gmres, SharesOneSpaceAmongDependentColumns) {
  const MatrixOperator a(second_kind(120, 0.5));
  const MatXcd two = noise(120, 2, 6);
  MatXcd b(120, 6), x(120, 6), expected(120, 2);
  b << two, two.col(0) + two.col(1), 3.0 * two.col(0), MatXcd::Zero(120, 1), 1e-200 * two.col(1);
  const GmresOptions options{.tolerance = 1e-9};
  const GmresReport pair = solve_gmres(a, {}, two, expected, options);
  const GmresReport report = solve_gmres(a, {}, b, x, options);
  EXPECT_LE(worst_residual(a.matrix(), b, x), 1e-9);
  EXPECT_EQ(x.col(4).norm(), 0.0);
  EXPECT_EQ(report.true_residual[4], 0.0);
  // The space is that of two columns; only the check of the residual counts all that are not zero
  EXPECT_LE(report.applications - 5, pair.applications - 2 + 2);
}

TEST(Gmres, SolvesNothingForNoColumnsOrZeroOnes) {
  const MatrixOperator a(second_kind(20, 0.5));
  MatXcd x(20, 2), none(20, 0);
  x.setOnes();
  EXPECT_EQ(solve_gmres(a, {}, MatXcd::Zero(20, 2), x).applications, 0);
  EXPECT_EQ(x.norm(), 0.0);
  EXPECT_EQ(solve_gmres(a, {}, none, none).true_residual.size(), 0);
}

TEST(Gmres, SolvesMoreColumnsThanUnknowns) {
  const MatrixOperator a(second_kind(5, 0.5));
  const MatXcd b = noise(5, 9, 8);
  MatXcd x(5, 9);
  const GmresReport report = solve_gmres(a, {}, b, x, {.tolerance = 1e-10});
  EXPECT_LE(worst_residual(a.matrix(), b, x), 1e-10);
  EXPECT_LE(report.applications, 5 + 9);  // the whole space, and the check
}

TEST(Gmres, StopsAtOnceInAnInvariantSpace) {
  const MatrixOperator a(2.0 * MatXcd::Identity(50, 50));
  const MatXcd b = noise(50, 3, 9);
  MatXcd x(50, 3);
  EXPECT_EQ(solve_gmres(a, {}, b, x, {.tolerance = 1e-12}).iterations, 1);
  EXPECT_LE(test::relative_error(x, 0.5 * b), 1e-12);
}

TEST(Gmres, RestartsAndTakesSmallerBlocksWhenMemoryIsShort) {
  const Index n = 2000;
  const Chain a(n);
  const MatXcd b = noise(n, 8, 10);
  const double vector = 16.0 * double(n);
  MatXcd x(n, 8), image(n, 8);
  GmresOptions options{.tolerance = 1e-8, .max_iterations = 2000};
  const GmresReport rich = solve_gmres(a, {}, b, x, options);
  EXPECT_EQ(rich.block_size, 8);
  EXPECT_EQ(rich.cycles, 1);
  options.memory = 4 * (7 + 30) * vector;
  const GmresReport halves = solve_gmres(a, {}, b, x, options);
  EXPECT_EQ(halves.block_size, 4);
  options.memory = (7 + 12) * vector;
  const GmresReport poor = solve_gmres(a, {}, b, x, options);
  EXPECT_EQ(poor.block_size, 1);
  EXPECT_GT(poor.cycles, 8);
  a.apply(x, image);
  EXPECT_LE(test::relative_error(image, b), 1e-8);
}

TEST(Gmres, RefusesABudgetWithoutRoomForOneColumn) {
  const MatrixOperator a(second_kind(50, 0.5));
  MatXcd x(50, 1);
  EXPECT_THROW(solve_gmres(a, {}, noise(50, 1, 1), x, {.memory = 5000.0}), BudgetError);
  EXPECT_THROW(solve_gmres(a, {}, noise(50, 1, 1), x, {.tolerance = 0.0}), InputError);
}

std::string message_of(const LinearOperator& a, const MatXcd& b, const GmresOptions& options) {
  MatXcd x(b.rows(), b.cols());
  try {
    solve_gmres(a, {}, b, x, options);
  } catch (const ConvergenceError& error) {
    return error.what();
  }
  return "converged";
}

TEST(Gmres, NamesTheColumnThatDoesNotConverge) {
  const Chain a(300);
  MatXcd b = noise(300, 3, 11);
  b.col(0).setZero();
  const std::string limit = message_of(a, b, {.tolerance = 1e-10, .max_iterations = 4});
  EXPECT_THAT(limit,
              testing::ContainsRegex("true residual of column [23] = .* after 4 iterations"));
  EXPECT_THAT(limit, testing::HasSubstr("(must be at most 1e-10)"));
}

TEST(Gmres, ReportsAStagnatingColumn) {
  // Singular, and the right-hand side of column 2 is outside its range
  MatXcd matrix = MatXcd::Identity(40, 40);
  matrix(9, 9) = 0.0;
  MatXcd b = noise(40, 2, 12);
  b(9, 0) = 0.0;
  EXPECT_THAT(message_of(MatrixOperator(matrix), b, {}),
              testing::ContainsRegex("true residual of column 2 = "));
}

TEST(Gmres, ReportsWhatIsNotFinite) {
  MatXcd matrix = second_kind(40, 0.5), b = noise(40, 2, 13);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message_of(MatrixOperator(nan * matrix), b, {}), testing::HasSubstr("true residual"));
  b(3, 1) = nan;
  EXPECT_THAT(message_of(MatrixOperator(matrix), b, {}), testing::HasSubstr("is not finite"));
}

TEST(Gmres, MayBeStoppedBeforeAnyStep) {
  const MatXcd matrix = second_kind(40, 0.5), b = noise(40, 2, 13);
  MatXcd x(40, 2);
  int steps = 0;
  GmresOptions options;
  options.before_step = [&] {
    if (++steps == 3) throw std::runtime_error("stop");
  };
  EXPECT_THROW(solve_gmres(MatrixOperator(matrix), {}, b, x, options), std::runtime_error);
  EXPECT_EQ(steps, 3);
}

TEST(Gmres, HasTheSameBitsForAnyNumberOfThreads) {
  const Index n = 5000;
  const Chain a(n);
  const MatXcd b = noise(n, 6, 14);
  const int before = omp_get_max_threads();
  for (const Basis basis : {Basis::double_precision, Basis::single_precision}) {
    MatXcd first;
    for (const int threads : {1, 2, 3, 7}) {
      omp_set_num_threads(threads);
      MatXcd x(n, 6);
      solve_gmres(a, {}, b, x, {.tolerance = 1e-7, .basis = basis});
      if (threads == 1) first = x;
      EXPECT_EQ(first, x) << threads << " threads";
    }
  }
  omp_set_num_threads(before);
}

}  // namespace
}  // namespace floe::krylov
