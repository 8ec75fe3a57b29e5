#pragma once

#include "pfft/lane_buffer.hpp"
#include "pfft/lane_fft.hpp"

#include <vector>

namespace floe::fmm::pfft {

/// Linear convolution of nx × ny grids with an even kernel (F.4): rows are transformed kLanes at a
/// time, one a lane, then columns, kLanes at a time, are transformed, multiplied and transformed
/// back while they stay in cache. What is zero or not wanted is left out. Same bits for any number
/// of threads.
template <class Real>
class LaneConvolution {
 public:
  /// `table` holds the kernel at offsets (i, j), 0 ≤ i < nx, 0 ≤ j < ny, x fastest.
  LaneConvolution(Index nx, Index ny, const std::vector<Complex>& table);

  /// Numbers of the spectrum between the transforms, which the caller keeps.
  Index workspace_size() const { return 2 * blocks() * block_size(); }

  /// Replaces the grid's values by their convolution. Numbers behind the end of a row are zero.
  void apply(GridData<Real>& grid, Real* workspace) const;

  double memory() const { return sizeof(Real) * static_cast<double>(spectrum_.size()); }

 private:
  // kLanes wavenumbers in x, positive or negative, by all rows: first + l, or -(first + l)
  Index blocks() const { return length_x() / 2 / kLanes<Real> + 1; }  // of either sign
  Index block_size() const { return 2 * kLanes<Real> * whole_lanes<Real>(ny_); }
  Index length_x() const { return along_x_.length(); }
  Index length_y() const { return along_y_.length(); }
  void transform_rows(const GridData<Real>& grid, Real* workspace) const;
  void transform_columns(Real* workspace) const;
  void restore_rows(const Real* workspace, GridData<Real>& grid) const;

  Index nx_, ny_;
  LaneFft<Real> along_x_, along_y_;
  std::vector<Real> spectrum_;  // block; wavenumber in y ≥ 0; re, im of kLanes wavenumbers in x ≥ 0
};

}  // namespace floe::fmm::pfft
