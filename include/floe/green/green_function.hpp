#pragma once

#include <floe/fmm/radial_kernel.hpp>
#include <floe/numeric/types.hpp>

#include <vector>

namespace floe::green {

/// Green function of the free surface for source and field point on z = 0, G ~ 2/R (G.1), paper
/// (10):
///   G(R) = c H0⁽¹⁾(kR) + F(R),   c = 2πi k²/(h(k²-ν²)+ν)                               (G.2)
/// with the real, non-oscillating remainder
///   F(R) = 4 Σ_n k_n²/(h(k_n²+ν²)-ν) K0(k_n R)                                         (G.3)
///        = 2/R - πν[H₀(νR) - Y0(νR)]  in infinite depth (H₀ the Struve function).      (G.4)
/// Evaluated exactly: relative error of G below 1e-11 for νh from 1e-6 to 1e3 (and infinite depth)
/// and R/h from 1e-6 to 1e3; a few microseconds a value. GreenTable is the fast way.
class GreenFunction {
 public:
  /// `nu` = ω²/g [rad/m], `depth` = h [m], may be infinite. Throws InputError unless both are
  /// positive.
  GreenFunction(double nu, double depth);

  /// G(R) [1/m] for a horizontal distance R ≥ 0 [m]; G(0) has an infinite real part. Never NaN;
  /// throws InputError when R is negative or NaN.
  Complex operator()(double distance) const;

  /// F(R) [1/m], R > 0.
  double remainder(double distance) const;

  double nu() const { return nu_; }
  double depth() const { return depth_; }
  double wavenumber() const { return static_cast<double>(wavenumber_); }  ///< k [rad/m]
  /// k and c of the wave part; c is imaginary.
  fmm::WaveTerm wave() const { return {wavenumber(), Complex(0.0, wave_amplitude_)}; }

 private:
  double remainder_series(double distance) const;
  double remainder_near(double distance) const;
  double remainder_infinite_depth(double distance) const;

  double nu_;
  double depth_;
  long double wavenumber_;
  double wave_amplitude_;                     // Im c
  std::vector<double> evanescent_;            // k_n, n = 1 …
  std::vector<double> evanescent_amplitude_;  // k_n²/(h(k_n²+ν²)-ν)
};

}  // namespace floe::green
