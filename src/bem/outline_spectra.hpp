#pragma once

#include "bem/node_lattices.hpp"

#include <floe/fmm/fft_plan.hpp>
#include <floe/fmm/padded_grid.hpp>
#include <floe/numeric/types.hpp>

#include <array>
#include <vector>

namespace floe::bem {

/// Spectra on one axis of sources that lie at i or i + 1/2 steps.
class AxisTransform {
 public:
  explicit AxisTransform(Index length);

  Index length() const { return length_; }
  /// e^{-2πi m (place + half/2)/length}, m = bin or, for the upper half, bin - length.
  Complex phase(Index place, bool half, Index bin) const;
  /// spectrum[bin] of `values` at all places; overwrites both. Aligned buffers (FftBuffer).
  void transform(Complex* values, bool half, Complex* spectrum) const;

 private:
  Index length_;
  std::vector<Complex> root_;  // e^{-πi k/length}, 0 ≤ k < 2·length
  fmm::FftPlan plan_;
};

/// The spectrum of sources on few lines is a sum of products, one a line:
///   Ŝ(m_x, m_y) = Σ_t u_t(m_x) v_t(m_y),                                        (F.15)
/// for lines along x the spectrum along the line by the phase of its y, for lines along y the phase
/// of its x by the spectrum along it. The signs of an odd kernel at negative wavenumbers are
/// included.
struct LineProducts {
  Index count = 0;
  /// For each block of x wavenumbers, its positive and negative sign, each term: kSpectralBlock
  /// real, then imaginary parts.
  std::vector<double> u;
  std::vector<Complex> v;  ///< at bin·count + t
};

/// The products of the sources `outline` for the nodal values x.
LineProducts line_products(const OutlineNodes& outline, const SourceKind& source,
                           const AxisTransform& along_x, const AxisTransform& along_y,
                           const Complex* x);

}  // namespace floe::bem
