#pragma once

#include <floe/fmm/even_spectrum.hpp>

namespace floe::fmm {

/// Linear convolution with an even kernel on one lattice of nx × ny points:
///   u(i, j) = Σ_kl K(|i - k|, |j - l|) q(k, l)                                           (F.4)
/// to rounding, by one PaddedGrid. Several kernels, several lattices: use PaddedGrid::convolve;
/// something else between the transforms: PaddedGrid::apply with a SpectralFilter; a factor in
/// wavenumber space: EvenSpectrum::from_symbol.
class GridConvolution {
 public:
  /// Keeps the grid (shared by convolutions with other kernels) and owns the kernel's spectrum.
  GridConvolution(std::shared_ptr<const PaddedGrid> grid, EvenSpectrum spectrum);

  /// data (nx·ny, x fastest) is replaced by its convolution. Thread-safe; see PaddedGrid.
  void apply(Complex* data, PaddedGrid::Workspace* workspace = nullptr) const;

  const PaddedGrid& grid() const { return *grid_; }
  double memory() const { return spectrum_.memory(); }  ///< [byte]

 private:
  std::shared_ptr<const PaddedGrid> grid_;
  EvenSpectrum spectrum_;
};

}  // namespace floe::fmm
