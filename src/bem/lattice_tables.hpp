#pragma once

#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/fmm/padded_grid.hpp>

#include <array>
#include <span>
#include <vector>

namespace floe::bem {

/// Sources by symmetry within an element: combinations of mirrored local nodes.
inline constexpr int kSymmetries = 8;
/// Whether the combination, and so its kernel, is odd in x, in y.
inline constexpr std::array<bool, kSymmetries> kOddX{false, true,  false, true,
                                                     false, false, false, true};
inline constexpr std::array<bool, kSymmetries> kOddY{false, false, true,  true,
                                                     false, true,  false, false};

/// Targets: corners, middles of horizontal sides, middles of vertical sides.
inline constexpr int kTargets = 3;

/// value[p] of eight local values (ElementLattice::Local): sums and differences over mirrored
/// nodes, scaled so that Σ_l a_l b_l = Σ_p combine(a)_p combine(b)_p.
std::array<Complex, kSymmetries> combine(const std::array<Complex, 8>& local);

/// Spectra of the 3 × 8 kernels of (F.5), the filter between the transforms.
class LatticeTables final : public fmm::SpectralFilter {
 public:
  LatticeTables(const LatticePlan& plan, const green::GreenTable& green);

  void filter(const fmm::SpectralBlock& block, std::span<const Complex* const> inputs,
              std::span<Complex* const> outputs) const override;

  double memory() const { return 8.0 * static_cast<double>(spectrum_.size()); }

 private:
  Index padded_ny_, half_ny_;
  /// For each block of x wavenumbers and each y wavenumber 0 … padded_ny/2: target, symmetry, then
  /// kSpectralBlock real and kSpectralBlock imaginary parts.
  std::vector<double> spectrum_;
};

}  // namespace floe::bem
