#include "plate/elastic_modes.hpp"

#include <floe/numeric/error.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace floe::plate {
namespace {

// The Krylov basis has twice as many columns as modes are sought at a time
constexpr Index kModesAtATime = 100;
// Two eigenvalues this close, relatively, may change places: either is the next one
constexpr double kSameEigenvalue = 1e-6;

// Rayleigh–Ritz in the span of the vectors, the deflated part taken out once more
void rayleigh_ritz(const SparseMatrix& stiffness, const NodeMass& mass, const MatXd& deflated,
                   Eigenpairs& pairs) {
  subtract_combination(deflated, inner_products(deflated, mass * pairs.vector), pairs.vector);
  const MatXd kinetic = inner_products(pairs.vector, mass * pairs.vector);
  const MatXd strain = inner_products(pairs.vector, multiply_symmetric(stiffness, pairs.vector));
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatXd> ritz(strain, kinetic);
  combine_columns(ritz.eigenvectors(), pairs.vector);
  pairs.value = ritz.eigenvalues();
}

// The first `count` pairs by rising eigenvalue
Eigenpairs lowest(const Eigenpairs& pairs, Index count) {
  std::vector<Index> order(pairs.value.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return pairs.value[a] < pairs.value[b]; });
  order.resize(std::min<std::size_t>(order.size(), count));
  return {pairs.value(order), pairs.vector(Eigen::all, order), pairs.solve_count};
}

}  // namespace

Eigenpairs elastic_modes(const ElasticProblem& problem, const DryModeOptions& wanted) {
  const Index count = wanted.count;
  const Index size = problem.mass.size(), rigid_count = problem.rigid_basis.cols();
  Eigenpairs found{VecXd(), MatXd(size, 0)};
  MatXd deflated = problem.rigid_basis;
  LanczosOptions options{.count = std::min(count, kModesAtATime),
                         .tolerance = wanted.tolerance,
                         .max_restarts = wanted.max_restarts};
  while (true) {
    // Seek modes orthogonal to all found so far
    Eigenpairs more =
        lowest_eigenpairs(problem.mass, problem.factor, problem.shift, deflated, options);
    FLOE_VALIDATE_AS(ConvergenceError, more.value.size() == options.count,
                     "dry modes converged = " << found.value.size() + more.value.size() << " of "
                                              << count << " elastic modes (all are needed)");
    rayleigh_ritz(problem.plate.stiffness, problem.mass, deflated, more);
    found.value.conservativeResize(found.value.size() + options.count);
    found.value.tail(options.count) = more.value;
    found.vector.conservativeResize(Eigen::NoChange, found.value.size());
    found.vector.rightCols(options.count) = more.vector;
    found.solve_count += more.solve_count;
    deflated.conservativeResize(Eigen::NoChange, rigid_count + found.value.size());
    deflated.rightCols(options.count) = more.vector;
    ++options.seed;
    if (found.value.size() < count) {
      options.count = std::min(count - found.value.size(), kModesAtATime);
      continue;
    }

    // Look for a mode that was missed: a copy of a multiple one, below the last that is wanted
    found = lowest(found, count);
    if (size - deflated.cols() < 2) return found;
    const Eigenpairs next =
        lowest_eigenpairs(problem.mass, problem.factor, problem.shift, deflated,
                          {.count = 1, .tolerance = 1e-3, .seed = options.seed});
    found.solve_count += next.solve_count;
    if (next.value.size() == 1 && next.value[0] >= (1.0 - kSameEigenvalue) * found.value[count - 1])
      return found;
    options.count = std::min<Index>(count, 4);
  }
}

Eigenpairs dense_elastic_modes(const PlateMatrices& plate, double shift, const MatXd& rigid_basis,
                               Index count) {
  // NOTE: solved as M c = θ (K + sM) c, whose largest θ are the lowest modes. The other way round
  // the error is relative to the highest eigenvalue, for thin plates 1e12 times the lowest.
  const MatXd mass(plate.mass);
  const MatXd shifted = MatXd(plate.stiffness) + shift * mass;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatXd> solver(mass, shifted);
  const Index elastic = mass.cols() - rigid_basis.cols();
  FLOE_EXPECT(count <= elastic);
  Eigenpairs pairs;
  pairs.vector = solver.eigenvectors().middleCols(elastic - count, count).rowwise().reverse();
  rayleigh_ritz(plate.stiffness, NodeMass(plate.mass), rigid_basis, pairs);
  return pairs;
}

VecXd inverse_residuals(const ElasticProblem& problem, const Eigenpairs& pairs) {
  constexpr Index kColumns = 16;
  VecXd residual(pairs.value.size());
  for (Index first = 0; first < residual.size(); first += kColumns) {
    const Index columns = std::min(kColumns, residual.size() - first);
    const MatXd load = problem.mass * pairs.vector.middleCols(first, columns);
    MatXd difference(load.rows(), columns);
    problem.factor.solve(load, difference);
    for (Index c = 0; c < columns; ++c)
      difference.col(c) = pairs.vector.col(first + c) -
                          (pairs.value[first + c] + problem.shift) * difference.col(c);
    const MatXd product = multiply_symmetric(problem.plate.stiffness, difference) +
                          problem.shift * (problem.mass * difference);
    for (Index c = 0; c < columns; ++c)
      residual[first + c] =
          std::sqrt(std::max(0.0, inner_products(difference.col(c), product.col(c))(0, 0)) /
                    (pairs.value[first + c] + problem.shift));
  }
  return residual;
}

}  // namespace floe::plate
