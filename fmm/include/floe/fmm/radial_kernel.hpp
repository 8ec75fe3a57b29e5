#pragma once

#include <complex>
#include <span>

namespace floe::fmm {

/// The propagating part c·H0⁽¹⁾(kR) of a kernel; the rest is real and does not oscillate.
struct WaveTerm {
  double wavenumber = 0.0;           ///< k
  std::complex<double> coefficient;  ///< c
};

/// A kernel that depends on the distance alone. Evaluated in blocks, never pair by pair.
class RadialKernel {
 public:
  virtual ~RadialKernel() = default;

  /// Fills value[i] with the kernel at distance[i] > 0. Both spans have the same length.
  virtual void evaluate(std::span<const double> distance,
                        std::span<std::complex<double>> value) const = 0;

  virtual WaveTerm wave() const = 0;
};

}  // namespace floe::fmm
