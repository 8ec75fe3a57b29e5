#pragma once

#include <floe/krylov/linear_operator.hpp>
#include <floe/numeric/types.hpp>

namespace floe::bem {

/// What a solution took.
struct SolveReport {
  Index iterations = 0;    ///< 0 for a direct solution
  Index applications = 0;  ///< columns to which the operator was applied
};

/// The operator I + κ𝒢 of (B.1), κ = ν/4π, on nodal values:
///   (I + κ𝒢) p = ρg (ζ - w)
/// for the total pressure p under a plate of deflection w in a wave of elevation ζ.
class PressureOperator : public krylov::LinearOperator {
 public:
  /// X = (I + κ𝒢)⁻¹ B in place, one column a right-hand side.
  virtual SolveReport solve(Eigen::Ref<MatXcd> rhs) const = 0;

  /// Name of the method as case files and run.json have it.
  virtual const char* method() const = 0;
};

}  // namespace floe::bem
