#pragma once

#include "bem/node_lattices.hpp"

#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/fmm/padded_grid.hpp>
#include <floe/green/green_table.hpp>

#include <array>
#include <vector>

namespace floe::bem {

/// Spectra of κ times the 3 × 8 kernels of (F.14), each even or odd in x and in y: a quarter of
/// each is stored, with the norm of the inverse transform.
class LatticeTables {
 public:
  LatticeTables(const LatticePlan& plan, const green::GreenTable& green);

  /// The spectrum of a source on one spectral block: as a whole, or as products.
  struct BlockSource {
    const double* values = nullptr;  ///< where not null; without the signs of odd kernels
    Index count = 0;                 ///< products
    const double* u = nullptr;       ///< of this block and sign, see LineProducts
    const Complex* v = nullptr;
  };
  using BlockSources = std::array<BlockSource, kSources>;

  /// outputs[a] = Σ_p K̂_ap Ŝ_p on one block.
  void multiply(const fmm::SpectralBlock& block, const BlockSources& sources,
                double* const* outputs) const;

  double memory() const { return 8.0 * static_cast<double>(spectrum_.size()); }  ///< [byte]

 private:
  Index padded_ny_;
  /// For each block of x wavenumbers, each bin 0 … padded_ny/2: source, target, kSpectralBlock
  /// real, then imaginary parts.
  std::vector<double> spectrum_;
};

}  // namespace floe::bem
