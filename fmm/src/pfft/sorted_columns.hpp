#pragma once

#include "pfft/grid.hpp"
#include "pfft/lane_buffer.hpp"

namespace floe::fmm::pfft {

/// Columns of charges or potentials in the order of the cells, real and imaginary part apart, with
/// some zeros behind each: near ranges are read in whole vectors.
template <class Real>
class SortedColumns {
 public:
  /// Values that nobody has set, but for the zeros.
  SortedColumns(Index count, Index columns);
  /// Divided by scale, one factor a column.
  SortedColumns(const CellPoints& points, const Eigen::Ref<const MatXcd>& values,
                const VecXd& scale);

  /// values (original order) = scale · these.
  void restore(const CellPoints& points, const VecXd& scale, Eigen::Ref<MatXcd> values) const;

  Index stride() const { return stride_; }  // from re to im, and from im to the next column
  Index columns() const { return columns_; }
  Real* re(Index column) const { return values_.data() + 2 * column * stride_; }
  Real* im(Index column) const { return re(column) + stride_; }

 private:
  Index stride_, columns_;
  LaneBuffer<Real> values_;
};

/// Powers of two near the largest number of each column: single precision has no room for charges
/// of any size, and the division is exact.
VecXd column_scales(const Eigen::Ref<const MatXcd>& charges);

}  // namespace floe::fmm::pfft
