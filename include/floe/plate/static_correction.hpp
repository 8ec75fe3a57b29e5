#pragma once

#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/types.hpp>
#include <floe/plate/dry_modes.hpp>
#include <floe/plate/plate_regions.hpp>

#include <memory>

namespace floe::plate {

class ShiftedFactor;

/// What a truncated sum of modes leaves out of the displacement (the mode-acceleration method):
/// the deflection converges quickly with the number of modes, the moments and shear forces slowly.
/// The loads that the modes do not carry,
///   r = ∫ N p dS - (K - ω²M) C ξ,   made orthogonal to the modes,                        (P.9)
/// bend the plate almost statically: (K - ω²M) δ = r, solved with the factor of K + sM and one
/// correction, which leaves a relative error of ((s + ω²)/ω_q²)² of δ.
class StaticCorrection {
 public:
  /// Factors K + sM of the whole plate; keeps the modes' inertia M C (3N × q).
  /// Throws as dry_modes.
  StaticCorrection(const mesh::Q8Mesh& mesh, const PlateRegions& regions, const DryModes& modes);

  /// δ, 3N × headings, from the pressure loads ∫ N_m p dS (N × headings [N/m]) and the amplitudes ξ
  /// of the modes (q × headings) at ω. To be added to C ξ.
  MatXcd displacement(const Eigen::Ref<const MatXcd>& load, double omega,
                      const MatXcd& amplitudes) const;

  /// The same seen from a linear functional c of the displacement, cᵀδ = ∫ a p dS with
  /// a = constant + (shift + ω²) slope, without the loss factor (E.12). Deflections at the nodes, N
  /// × functionals, of the rows of `functional` (functionals × 3N).
  struct Influence {
    MatXd constant;      ///< [unit of the functional per N]
    MatXd slope;         ///< [the same s²]
    double shift = 0.0;  ///< [1/s²]
    MatXd at(double omega) const { return constant + (shift + omega * omega) * slope; }
  };
  Influence influence(const SparseMatrix& functional) const;

 private:
  DryModes modes_;
  double loss_factor_;
  double shift_;
  SparseMatrix mass_;
  MatXd inertia_;  // M C
  std::shared_ptr<const ShiftedFactor> factor_;
};

}  // namespace floe::plate
