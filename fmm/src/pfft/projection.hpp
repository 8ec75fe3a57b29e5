#pragma once

#include "pfft/grid.hpp"
#include "pfft/lane_buffer.hpp"

namespace floe::fmm::pfft {

/// Grid = Σ_k weights of point k · charge k, points in the order of their cells           (F.4)
template <class Real>
void project(const Grid& grid, const CellPoints& points, const Real* charges_re,
             const Real* charges_im, GridData<Real>& values);

/// Potential k = Σ weights of point k · grid values                                       (F.4)
template <class Real>
void interpolate(const Grid& grid, const CellPoints& points, const GridData<Real>& values,
                 Real* potentials_re, Real* potentials_im);

}  // namespace floe::fmm::pfft
