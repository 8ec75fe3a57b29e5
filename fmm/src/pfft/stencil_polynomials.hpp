#pragma once

#include "pfft/lanes.hpp"

#include <type_traits>

namespace floe::fmm::pfft {

inline constexpr int kWeights = 8;  // room for the weights of one axis; the largest stencil

/// A point's weights along one axis as whole vectors, zeros behind the stencil.
template <class Real>
struct AxisWeights {
  static constexpr int kVectors = static_cast<int>(kWeights / kLanes<Real>);
  Lanes<Real> vector[kVectors];
};

/// The weights as polynomials of a point's place t within its stencil: cheaper to evaluate than to
/// bring from memory.
template <class Real>
class StencilPolynomials {
 public:
  explicit StencilPolynomials(int stencil);

  int stencil() const { return stencil_; }

  /// t from the stencil's centre, in spacings, |t| ≤ 1/2.
  FLOE_INLINE void evaluate(Real t, AxisWeights<Real>& weights) const {
    evaluate_of(stencil_, t, weights);
  }
  /// The same where the length is known to the compiler.
  FLOE_INLINE void evaluate_of(int stencil, Real t, AxisWeights<Real>& weights) const {
    for (int v = 0; v < AxisWeights<Real>::kVectors; ++v) {
      Lanes<Real> sum;
      load(sum, coefficient_[stencil - 1] + kLanes<Real> * v);
      for (int power = stencil - 2; power >= 0; --power) {
        Lanes<Real> next;
        load(next, coefficient_[power] + kLanes<Real> * v);
        sum = sum * t + next;
      }
      weights.vector[v] = sum;
    }
  }

 private:
  int stencil_;
  Real coefficient_[kWeights][kWeights] = {};  // of t^power, by stencil point
};

/// Calls with the length of a stencil as a constant, std::integral_constant.
template <class Call>
FLOE_INLINE void for_stencil(int stencil, const Call& call) {
  switch (stencil) {
    case 2:
      return call(std::integral_constant<int, 2>());
    case 3:
      return call(std::integral_constant<int, 3>());
    case 4:
      return call(std::integral_constant<int, 4>());
    case 5:
      return call(std::integral_constant<int, 5>());
    case 6:
      return call(std::integral_constant<int, 6>());
    case 7:
      return call(std::integral_constant<int, 7>());
    default:
      return call(std::integral_constant<int, 8>());
  }
}

}  // namespace floe::fmm::pfft
