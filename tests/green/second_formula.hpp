#pragma once

#include <cmath>
#include <complex>
#include <numbers>

/// The Green function by another formula than the engine's: an integral along a ray of the complex
/// wavenumber plane (G.8), its Bessel function by an integral too. No series, no evanescent roots.
namespace floe::test {

/// K0(w), Re w > 0, as ∫_0^∞ e^{-w cosh t} dt by the trapezoidal rule. For arg w = -π/4 the
/// integrand is analytic and decays within |Im t| < π/4: step 0.11 leaves e^{-2π(π/4)/0.11} =
/// 3e-20.
inline std::complex<double> bessel_k0(std::complex<double> w) {
  constexpr double kStep = 0.11;
  std::complex<double> sum = 0.5 * std::exp(-w);
  for (int i = 1;; ++i) {
    const double t = i * kStep;
    if (w.real() * std::cosh(t) > 45.0 + w.real()) break;
    sum += std::exp(-w * std::cosh(t));
  }
  return kStep * sum;
}

/// F(R) = Re ∫ 2μ/(μ tanh μh - ν) H0⁽¹⁾(μR) dμ from 0 to ∞e^{iπ/4}, by the trapezoidal rule in ln
/// μ: the poles lie on the axes, π/4 away in the imaginary direction, as above.
inline double remainder(double nu, double depth, double distance) {
  constexpr double kStep = 0.11;
  const std::complex<double> ray = std::polar(1.0, std::numbers::pi / 4.0);
  const double top = std::log(70.0 / distance);
  double sum = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const std::complex<double> mu = ray * std::exp(top - i * kStep);
    const std::complex<double> hankel = std::complex<double>(0.0, -2.0 / std::numbers::pi) *
                                        bessel_k0(std::complex<double>(0.0, -1.0) * mu * distance);
    const std::complex<double> e = std::exp(-2.0 * mu * depth);
    const std::complex<double> tanh = (1.0 - e) / (1.0 + e);
    // NOTE: for small μh the quotient loses nothing that matters: μ tanh μh is small against ν
    // there
    sum += (2.0 * mu / (mu * tanh - nu) * hankel * mu).real();
  }
  return kStep * sum;
}

}  // namespace floe::test
