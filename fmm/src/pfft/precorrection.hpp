#pragma once

#include "pfft/grid.hpp"

#include <functional>

namespace floe::fmm::pfft {

/// What the grid gives for near pairs (F.5): stencilᵀ · kernel table · stencil. Per target first
/// the potential of its stencil on the grid points around, then w² products a source.
class Precorrection {
 public:
  /// `table(i, j)` is the kernel at grid offset (i, j) ≥ 0 as the convolution has it.
  Precorrection(const Geometry& geometry, const std::function<Complex(Index, Index)>& table);

  /// Potential of a target's stencil on the box of grid points that near sources' stencils touch.
  class Box {
   public:
    explicit Box(const Precorrection& parent);
    void fill(Index target);
    Complex value(Index source) const;

   private:
    const Precorrection& parent_;  // view
    Index cell_x_ = 0, cell_y_ = 0;
    std::vector<double> strip_, potential_;
  };

 private:
  const Geometry& geometry_;  // view
  int stencil_, radius_, reach_, width_;
  std::vector<double> table_;  // rows dy = 0 … reach; dx = -reach … reach; re, im
};

}  // namespace floe::fmm::pfft
