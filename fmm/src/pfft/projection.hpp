#pragma once

#include "pfft/grid.hpp"

namespace floe::fmm::pfft {

/// grid (nx·ny) = Σ_k weights of point k · charges[original number of k]                 (F.4)
void project(const Grid& grid, const CellPoints& points, const Complex* charges, Complex* values);

/// potentials[original number of k] = Σ weights of point k · grid values                 (F.4)
void interpolate(const Grid& grid, const CellPoints& points, const Complex* values,
                 Complex* potentials);

}  // namespace floe::fmm::pfft
