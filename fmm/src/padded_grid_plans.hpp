#pragma once

#include "column_fft.hpp"

#include <floe/fmm/padded_grid.hpp>

#include <vector>

namespace floe::fmm {

struct PaddedGrid::Plans {
  Plans(Index padded_nx, Index padded_ny);

  ColumnFft x, y;
  std::vector<Complex> phase_x, phase_y;  // e^{πi m/length} of each bin, half a step
};

}  // namespace floe::fmm
