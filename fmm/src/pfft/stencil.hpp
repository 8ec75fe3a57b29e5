#pragma once

#include <floe/numeric/types.hpp>

namespace floe::fmm::pfft {

/// First grid point of the stencil of a point at `position` spacings, along one axis. An even
/// stencil lies around the interval of the point, an odd one around the nearest grid point.
Index stencil_begin(double position, int stencil);

/// Weights of `stencil` grid points 0, 1, … for a point at `position` spacings among them:
/// Lagrange interpolation, exact for polynomials of degree stencil - 1.
void stencil_weights(double position, int stencil, double* weight);

/// Error of a plane wave of wavenumber · spacing = `phase`, both ends together, root mean square
/// over the positions.
double stencil_wave_error(int stencil, double phase);

}  // namespace floe::fmm::pfft
