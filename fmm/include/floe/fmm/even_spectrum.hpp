#pragma once

#include <floe/fmm/padded_grid.hpp>

#include <functional>

namespace floe::fmm {

/// The spectrum, on a PaddedGrid, of a kernel that is even in x and in y: a quarter is stored,
/// 4·padded_nx()·padded_ny() bytes, in the order in which the grid runs through its blocks.
class EvenSpectrum final : public SpectralFilter {
 public:
  /// A value for a pair of numbers ≥ 0; called by one thread.
  using Function = std::function<Complex(Index, Index)>;

  /// Where the kernel's samples lie, for each axis: at offsets i or i + 1/2 steps. It couples an
  /// input lattice to an output lattice that is shifted alike (integer) or by half a step (half).
  enum class Centre { integer, half };

  /// From the kernel at offset (i + 0 or 1/2, j + 0 or 1/2), 0 ≤ i < nx, 0 ≤ j < ny:
  ///   K̂(m_x, m_y) = Σ_ij K(i, j) e^{-2πi(m_x i/padded_nx + m_y j/padded_ny)}
  /// over both signs of the offsets. Costs half a 2-D FFT.
  EvenSpectrum(const PaddedGrid& grid, const Function& kernel, Centre x = Centre::integer,
               Centre y = Centre::integer);

  /// From a symbol K̂ given for wavenumber numbers 0 ≤ m_x ≤ padded_nx/2, 0 ≤ m_y ≤ padded_ny/2.
  static EvenSpectrum from_symbol(const PaddedGrid& grid, const Function& symbol);

  /// output (+)= K̂ · input on one block.
  void multiply(const SpectralBlock& block, const double* input, double* output) const;
  void multiply_add(const SpectralBlock& block, const double* input, double* output) const;

  /// The filter with one input and one output.
  void filter(const SpectralBlock& block, std::span<const double* const> inputs,
              std::span<double* const> outputs) const override;

  double memory() const { return 8.0 * static_cast<double>(value_.size()); }  ///< [byte]

 private:
  explicit EvenSpectrum(const PaddedGrid& grid);

  void set(Index mx, Index my, Complex value);

  Index padded_nx_, padded_ny_;
  // Blocks; bins 0 … padded_ny/2; kSpectralBlock real, then imaginary parts; over the FFT's size
  std::vector<double> value_;
};

}  // namespace floe::fmm
