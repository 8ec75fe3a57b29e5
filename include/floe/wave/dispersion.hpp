#pragma once

#include <floe/wave/water.hpp>

namespace floe::wave {

/// ν = ω²/g [rad/m], the wavenumber in infinitely deep water (W.1), paper (8a).
double deep_wavenumber(double omega, const Water& water);

/// Propagating wavenumber k [rad/m]: the positive root of
///   k tanh(kh) = ω²/g                                                                 (W.2)
/// for any ω > 0 and any depth, infinite included; relative error below 4e-16.
/// Throws InputError when ω, the depth or gravity is not positive.
double wavenumber(double omega, const Water& water);

/// The same root from ν and h, in extended precision: phases k·R of 1e6 keep ten digits.
long double wavenumber_extended(double nu, double depth);

/// n-th evanescent wavenumber k_n [rad/m], n ≥ 1: the root of
///   k_n tan(k_n h) = -ν,   (n - ½)π < k_n h ≤ nπ                                      (W.3)
/// Relative error below 4e-16. Needs a finite depth.
double evanescent_wavenumber(int n, double nu, double depth);

/// c_g = dω/dk [m/s], the speed of energy (W.4).
double group_velocity(double omega, const Water& water);

/// ω [rad/s] of the wave with wavenumber k [rad/m]: (W.2) read the other way.
double angular_frequency(double wavenumber, const Water& water);

}  // namespace floe::wave
