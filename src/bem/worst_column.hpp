#pragma once

#include <floe/numeric/types.hpp>

#include <algorithm>
#include <cmath>

namespace floe::bem {

/// Root mean square of each column of `residual` over that of the same column of `relative_to`,
/// which may have another number of rows; the largest of the columns. NaN if any is.
inline double worst_column(const MatXcd& residual, const Eigen::Ref<const MatXcd>& relative_to) {
  const double rows = static_cast<double>(residual.rows());
  const double all_rows = static_cast<double>(relative_to.rows());
  double worst = 0.0;
  for (Index column = 0; column < residual.cols(); ++column) {
    const double mean = residual.col(column).norm() / std::sqrt(rows);
    const double scale = relative_to.col(column).norm() / std::sqrt(all_rows);
    const double relative = mean / scale;
    if (std::isnan(relative)) return relative;
    worst = std::max(worst, relative);
  }
  return worst;
}

}  // namespace floe::bem
