#pragma once

#include "pfft/grid.hpp"
#include "pfft/lane_buffer.hpp"
#include "pfft/stencil_polynomials.hpp"

#include <functional>
#include <span>

namespace floe::fmm::pfft {

/// What the grid gives for near pairs (F.5), of a real table: stencilᵀ · table · stencil. Per
/// target first the potential of its stencil on the grid points around, then w² products a source.
template <class Real>
class Precorrection {
 public:
  /// `table(i, j)` is the kernel at grid offset (i, j) ≥ 0 as the convolution has it.
  Precorrection(const Geometry& geometry, const std::function<double(Index, Index)>& table);

  /// Potential of a target's stencil on the box of grid points that near sources' stencils touch.
  class Box {
   public:
    explicit Box(const Precorrection& parent) : parent_(parent) {}
    void fill(Index target);
    /// The grid's values for sources, all by sorted numbers.
    void values(std::span<const std::int32_t> sources, Real* value) const;

   private:
    // Rows of the largest box
    static constexpr Index kRow = whole_lanes<Real>(2 * kLargestRadius + kWeights);
    static constexpr Index kRows = 2 * kLargestRadius + kWeights;

    const Precorrection& parent_;  // view
    std::int32_t cell_x_ = 0, cell_y_ = 0;
    Real strip_[kRow * (kLargestRadius + kWeights)], potential_[kRow * kRows];
  };

 private:
  const Geometry& geometry_;  // view
  StencilPolynomials<Real> polynomials_;
  int radius_, reach_;    // cells; grid offsets
  Index width_, stride_;  // of the box, and of its rows: whole vectors
  Index table_stride_;
  LaneBuffer<Real> table_;  // rows dy = 0 … reach; dx = -reach … reach, zeros
};

}  // namespace floe::fmm::pfft
