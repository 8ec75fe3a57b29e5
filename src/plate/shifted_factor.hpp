#pragma once

#include <floe/plate/mindlin.hpp>

#include <memory>

namespace floe::plate {

/// Sparse Cholesky factor of K + sM, s > 0 (CHOLMOD, supernodal; nested dissection of the nodes).
class ShiftedFactor final {
 public:
  /// Throws BudgetError when memory does not suffice or the factor is too large, and
  /// ConvergenceError when K + sM is not positive definite in floating point.
  ShiftedFactor(const PlateMatrices& plate, double shift);
  ~ShiftedFactor();
  ShiftedFactor(ShiftedFactor&&) noexcept;
  ShiftedFactor& operator=(ShiftedFactor&&) noexcept;

  Index size() const;
  Index entry_count() const;  ///< entries of the factor, the zeros inside supernodes included

  /// x = (K + sM)⁻¹ rhs, any number of real or complex columns. Not for several threads at a time:
  /// they would share the work space.
  void solve(const Eigen::Ref<const MatXd>& rhs, Eigen::Ref<MatXd> x) const;
  MatXcd solve(const Eigen::Ref<const MatXcd>& rhs) const;

 private:
  template <typename Columns>
  Eigen::Map<const Columns> solution_of(const Eigen::Ref<const Columns>& rhs, int type) const;

  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace floe::plate
