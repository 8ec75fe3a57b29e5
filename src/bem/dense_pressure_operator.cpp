#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/numeric/error.hpp>

#include <numbers>

namespace floe::bem {
namespace {

constexpr Index kRows =
    8;  // rows assembled together: half a page of each column is written at once

MatXcd pressure_matrix(const ElementIntegrals& integrals, const green::GreenTable& green) {
  MatXcd matrix = assemble_green_matrix(integrals, green);
  matrix *= green.exact().nu() / (4.0 * std::numbers::pi);
  matrix.diagonal().array() += 1.0;
  return matrix;
}

}  // namespace

MatXcd assemble_green_matrix(const ElementIntegrals& integrals, const green::GreenTable& green) {
  const Index n = integrals.mesh().node_count();
  MatXcd matrix(n, n);
  bool finite = true;
#pragma omp parallel for schedule(dynamic, 1) reduction(&& : finite)
  for (Index first = 0; first < n; first += kRows) {
    const Index count = std::min(kRows, n - first);
    MatXcd rows(n, count);
    for (Index i = 0; i < count; ++i) integrals.node_row(first + i, green, rows.col(i));
    finite = finite && rows.allFinite();
    matrix.middleRows(first, count) = rows.transpose();
  }
  FLOE_VALIDATE_AS(
      ConvergenceError, finite,
      "Green function matrix is not finite at nu = " << green.exact().nu() << " rad/m");
  return matrix;
}

DensePressureOperator::DensePressureOperator(const ElementIntegrals& integrals,
                                             const green::GreenTable& green)
    : matrix_(pressure_matrix(integrals, green)), factors_(matrix_) {}

void DensePressureOperator::apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const {
  constexpr Index kTile = 256;
  const Index n = matrix_.rows();
#pragma omp parallel for schedule(dynamic, 1)
  for (Index first = 0; first < n; first += kTile) {
    const Index count = std::min(kTile, n - first);
    y.middleRows(first, count).noalias() = matrix_.middleRows(first, count) * x;
  }
}

SolveReport DensePressureOperator::solve(Eigen::Ref<MatXcd> rhs) const {
  factors_.solve(rhs);
  return {};
}

}  // namespace floe::bem
