#pragma once

#include <floe/bem/damped_wave_preconditioner.hpp>
#include <floe/fmm/even_spectrum.hpp>
#include <floe/green/green_function.hpp>
#include <floe/mesh/q8_mesh.hpp>

namespace floe::bem {

/// Edge of the cells of a grid [m] with so many points a wavelength, but no finer than half the
/// distance of the mesh's nodes nor than `least`. The shorter side of the bounding box is a whole
/// number of cells.
double grid_step(const mesh::Q8Mesh& mesh, double wavenumber, double points_per_wavelength,
                 double least);

/// (τ - ν')/τ - 1 with τ = μ tanh μh, ν' = ν(1 + i·damping/(kB)), on the wavenumbers of a grid
/// (S.5), or with a plate that of the coupled equation (S.7). At μ = 0, where (S.5) is infinite,
/// the value at half the grid's smallest wavenumber.
fmm::EvenSpectrum damped_wave_spectrum(const fmm::PaddedGrid& grid, double step,
                                       const green::GreenFunction& green, double width,
                                       const DampedWaveOptions& options);

}  // namespace floe::bem
