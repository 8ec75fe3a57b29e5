#pragma once

#include "multipole/aligned_array.hpp"
#include "multipole/interaction_lists.hpp"
#include "multipole/level_basis.hpp"
#include "multipole/products.hpp"

#include <array>

namespace floe::fmm::multipole {

/// A matrix as `products.hpp` wants it: rows and columns padded with zeros, column by column.
template <class Real>
AlignedArray<Real> padded_columns(const MatXd& matrix) {
  const Index rows = padded<Real>(matrix.rows());
  AlignedArray<Real> result(rows * padded<Real>(matrix.cols()));
  for (Index j = 0; j < matrix.cols(); ++j)
    for (Index i = 0; i < matrix.rows(); ++i)
      result.data()[j * rows + i] = static_cast<Real>(matrix(i, j));
  return result;
}

/// Moments of the parent from those of child 0 … 3 (M2M), the children being on level + 1   (F.13);
/// its transpose takes local expansions down (L2L).
MatXd child_to_parent(const Bases& bases, std::size_t level, int child);

/// expandᵀ G expand between two boxes of a level, `offset` = centre of source - centre of target:
/// Re for the lists (M2L), Im for the coupling at the top.
MatXd box_to_box_real(const RadialKernel& kernel, const LevelBasis& basis, const Point2& offset);
MatXd box_to_box_imag(const RadialKernel& kernel, const LevelBasis& basis, const Point2& offset);

/// The translation matrices of one level.
template <class Real>
struct LevelMatrices {
  Index rank = 0, stride = 0;                  ///< functions a box; the same padded
  std::array<AlignedArray<Real>, 4> up, down;  ///< M2M from, L2L to child 0 … 3 on the next level
  std::array<AlignedArray<Real>, kOffsets> across;  ///< M2L by offset; empty where no pair asks
};

}  // namespace floe::fmm::multipole
