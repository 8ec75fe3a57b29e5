#pragma once

#include "pfft/lanes.hpp"

#include <vector>

namespace floe::fmm::pfft {

/// kLanes complex transforms at once, one a lane, of sequences whose second half is zero (forward)
/// or not wanted (backward), unnormalised. Element i has its real parts at 2·kLanes·i and its
/// imaginary parts behind. No planner: the same instructions in every run. Thread-safe.
///
/// Stockham's decimation in frequency: with n = n₁ ⋯ and s the product of the radices done,
///   y[q + s(rp + k)] = e^{-2πi pk/n} Σ_l e^{-2πi kl/r} x[q + s(p + l n/r)]
template <class Real>
class LaneFft {
 public:
  /// Length 2^a 3^b 5^c with a ≥ 2; fast_length gives the next one.
  explicit LaneFft(Index length);
  static Index fast_length(Index least);

  Index length() const { return length_; }
  /// Numbers that each of the two buffers of a transform must hold.
  Index buffer_size() const { return 2 * kLanes<Real> * (length_ + kLanes<Real>); }

  /// X_m = Σ x_j e^{-2πi jm/length} from elements 0 … length/2 - 1 of data. Returns the buffer,
  /// data or work, that holds the result.
  Real* forward(Real* data, Real* work) const;
  /// x_j = Σ X_m e^{+2πi jm/length} for elements 0 … length/2 - 1.
  Real* backward(Real* data, Real* work) const;

 private:
  struct Pass {
    int radix;
    Index groups, stride;       // n/r and s
    std::vector<Real> twiddle;  // r - 1 complex numbers for each p
  };
  static std::vector<Pass> make_passes(Index length, const std::vector<int>& radices);

  Index length_;
  std::vector<Pass> forward_, backward_;
};

}  // namespace floe::fmm::pfft
