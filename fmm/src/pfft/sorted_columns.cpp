#include "pfft/sorted_columns.hpp"

#include <floe/numeric/simd.hpp>

#include <algorithm>
#include <cmath>

namespace floe::fmm::pfft {

template <class Real>
SortedColumns<Real>::SortedColumns(Index count, Index columns)
    : stride_(whole_lanes<Real>(count) + kLanes<Real>),
      columns_(columns),
      values_(2 * stride_ * columns) {
  for (Index part = 1; part <= 2 * columns; ++part)
    std::fill(values_.data() + (part - 1) * stride_ + count, values_.data() + part * stride_,
              Real(0));
}

template <class Real>
SortedColumns<Real>::SortedColumns(const CellPoints& points, const Eigen::Ref<const MatXcd>& values,
                                   const VecXd& scale)
    : SortedColumns(points.count(), values.cols()) {
#pragma omp parallel
  for (Index c = 0; c < columns_; ++c) {
    const Complex* const from = values.col(c).data();
    Real *const to_re = re(c), *const to_im = im(c);
    const double inverse = 1.0 / scale[c];
#pragma omp for schedule(static) nowait
    for (Index k = 0; k < points.count(); ++k) {
      const Complex value = from[points.original[k]];
      to_re[k] = static_cast<Real>(inverse * value.real());
      to_im[k] = static_cast<Real>(inverse * value.imag());
    }
  }
}

template <class Real>
void SortedColumns<Real>::restore(const CellPoints& points, const VecXd& scale,
                                  Eigen::Ref<MatXcd> values) const {
#pragma omp parallel
  for (Index c = 0; c < columns_; ++c) {
    Complex* const to = values.col(c).data();
    const Real *const from_re = re(c), *const from_im = im(c);
    const double factor = scale[c];
#pragma omp for schedule(static) nowait
    for (Index k = 0; k < points.count(); ++k)
      to[points.original[k]] = Complex(factor * static_cast<double>(from_re[k]),
                                       factor * static_cast<double>(from_im[k]));
  }
}

namespace {

FLOE_SIMD_CLONES double largest_part(const double* part, Index count) {
  constexpr Index kWays = 16;
  double most[kWays] = {};
  Index i = 0;
  for (; i + kWays <= count; i += kWays)
    for (Index l = 0; l < kWays; ++l)
      most[l] = std::abs(part[i + l]) > most[l] ? std::abs(part[i + l]) : most[l];
  for (; i < count; ++i) most[0] = std::max(most[0], std::abs(part[i]));
  return *std::max_element(most, most + kWays);
}

}  // namespace

VecXd column_scales(const Eigen::Ref<const MatXcd>& charges) {
  VecXd scale(charges.cols());
#pragma omp parallel for schedule(static)
  for (Index c = 0; c < charges.cols(); ++c) {
    const double most =
        largest_part(reinterpret_cast<const double*>(charges.col(c).data()), 2 * charges.rows());
    scale[c] = most > 0.0 && std::isfinite(most) ? std::ldexp(1.0, std::ilogb(most)) : 1.0;
  }
  return scale;
}

template class SortedColumns<float>;
template class SortedColumns<double>;

}  // namespace floe::fmm::pfft
