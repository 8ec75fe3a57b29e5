#pragma once

#include <floe/bem/element_integrals.hpp>
#include <floe/bem/pressure_operator.hpp>
#include <floe/green/green_table.hpp>
#include <floe/numeric/dense_lu.hpp>

namespace floe::bem {

/// 𝒢 by nodal collocation as a dense matrix, row = collocation node; assembled in parallel, same
/// bits for any number of threads. 16 N² bytes. Throws ConvergenceError when an entry is not
/// finite.
MatXcd assemble_green_matrix(const ElementIntegrals& integrals, const green::GreenTable& green);

/// I + κ𝒢 as a dense matrix with its LU factors: the truth to which the fast operators are
/// compared. 32 N² bytes.
class DensePressureOperator final : public PressureOperator {
 public:
  DensePressureOperator(const ElementIntegrals& integrals, const green::GreenTable& green);

  Index size() const override { return matrix_.rows(); }
  void apply(const Eigen::Ref<const MatXcd>& x, Eigen::Ref<MatXcd> y) const override;
  SolveReport solve(Eigen::Ref<MatXcd> rhs) const override;
  const char* method() const override { return "dense"; }

 private:
  MatXcd matrix_;
  numeric::DenseLu factors_;
};

}  // namespace floe::bem
