#pragma once

#include <floe/plate/plate_properties.hpp>
#include <floe/wave/water.hpp>

namespace floe::hydro {

/// Wavenumber k [rad/m] of the wave that runs along an unbounded floating plate: the positive root
/// of, with D the bending rigidity and m the mass per area,
///   (D k⁴ + ρg - mω²) k tanh(kh) = ρω²                                                  (H.1)
/// for any ω > 0 and any depth; thin-plate theory, relative error of the root below 1e-12.
/// Throws InputError when ω is not positive.
double flexural_wavenumber(double omega, const wave::Water& water,
                           const plate::PlateProperties& properties);

}  // namespace floe::hydro
