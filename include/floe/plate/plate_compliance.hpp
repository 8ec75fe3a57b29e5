#pragma once

#include <floe/numeric/types.hpp>
#include <floe/plate/mindlin.hpp>

#include <memory>

namespace floe::plate {

class ShiftedFactor;

/// The displacement of a free plate on an elastic foundation under loads that vibrate with ω, by
/// one sparse factor instead of modes:
///   (K (1 - iη) - ω² M + E) d = f                                                       (P.11)
/// With a foundation of at least the plate's inertia, E ≥ ω² M, the real part is positive definite.
class PlateCompliance {
 public:
  /// `foundation` is E on the deflections, N × N, symmetric [N/m]. A loss factor η costs some
  /// log(1e-12) / log(η) solves for each load. Throws InputError for η above 0.5, BudgetError when
  /// memory does not suffice and ConvergenceError when the matrix is not positive definite.
  PlateCompliance(const PlateMatrices& plate, double loss_factor, double omega,
                  const SparseMatrix& foundation);

  /// d, 3N × columns, of loads on the deflections, N × columns [N]. Relative error 1e-11. Not for
  /// several threads at a time.
  MatXcd displacement(const Eigen::Ref<const MatXcd>& load) const;

  Index entry_count() const;  ///< of the factor, 8 bytes each

 private:
  double loss_factor_;
  SparseMatrix stiffness_;  // only where there is a loss
  std::shared_ptr<const ShiftedFactor> factor_;
};

}  // namespace floe::plate
