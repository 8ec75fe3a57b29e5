#pragma once

#include <floe/fmm/fft_plan.hpp>
#include <floe/fmm/padded_grid.hpp>

namespace floe::fmm {

struct PaddedGrid::Plans {
  Plans(Index padded_nx, Index padded_ny);

  FftPlan forward_x, backward_x;  // one row
  FftPlan forward_y, backward_y;  // the columns of a spectral block
  std::vector<Complex> phase_y;   // e^{πi m/padded_ny}, m = 0 … padded_ny/2
};

}  // namespace floe::fmm
