#include "bem/near_matrix.hpp"

#include "bem/near_products.hpp"
#include "bem/near_rows.hpp"

#include <floe/numeric/error.hpp>

#include <algorithm>
#include <cmath>

namespace floe::bem {
namespace {

constexpr Index kSampledRows = 32;
constexpr double kShare = 1.0 / 3.0;  // of the tolerance

// Root mean square difference of the two ways, over that of the integrals over near elements
bool moments_do(const NearSetup& setup, double tolerance) {
  const NearPattern& pattern = setup.pattern;
  NearRow by_moments(setup), exact(setup);
  double error = 0.0, norm = 0.0;
  const Index samples = std::min(kSampledRows, pattern.rows());
  for (Index s = 0; s < samples; ++s) {
    const Index row = (2 * s + 1) * pattern.rows() / (2 * samples);
    const Index block = row / NearPattern::kBlockRows;
    const auto& value = by_moments.from_moments(row);
    const auto& expected = exact.integrated(block, row);
    for (std::size_t k = 0; k < value.size(); ++k) error += std::pow(value[k] - expected[k], 2);
    norm += exact.squared_integrals();
  }
  return error <= std::pow(kShare * tolerance, 2) * norm;
}

}  // namespace

template <class Real>
NearMatrix<Real>::NearMatrix(const NearSetup& setup, double tolerance)
    : value_(setup.pattern.entry_count()) {
  const NearPattern& pattern = setup.pattern;
  const bool by_moments = moments_do(setup, tolerance);
  bool finite = true;
#pragma omp parallel reduction(&& : finite)
  {
    NearRow row(setup);
#pragma omp for schedule(dynamic, 4)
    for (Index block = 0; block < pattern.blocks(); ++block) {
      const Index first = block * NearPattern::kBlockRows;
      const Index last = std::min(pattern.rows(), first + NearPattern::kBlockRows);
      for (Index i = first; i < last; ++i) {
        const std::vector<double>& values =
            by_moments ? row.from_moments(i) : row.integrated(block, i);
        Real* const at = value_.data() + pattern.entry_begin(i);
        for (std::size_t k = 0; k < values.size(); ++k) {
          finite = finite && std::isfinite(values[k]);
          at[k] = static_cast<Real>(values[k]);
        }
      }
    }
  }
  FLOE_VALIDATE_AS(
      ConvergenceError, finite,
      "near field has an entry that is not finite at nu = " << setup.green.exact().nu());
}

template <class Real>
void NearMatrix<Real>::multiply_add(const NearPattern& pattern, const Eigen::Ref<const MatXcd>& x,
                                    double scale, Eigen::Ref<MatXcd> y) const {
  for (Index column = 0; column < x.cols();) {
    const Index width = x.cols() - column >= kNearColumns ? kNearColumns : 1;
#pragma omp parallel
    {
      std::vector<double> gathered;
#pragma omp for schedule(dynamic, 64)
      for (Index block = 0; block < pattern.blocks(); ++block)
        add_near_block(pattern, block, value_.data(), x.middleCols(column, width), scale, gathered,
                       y.middleCols(column, width));
    }
    column += width;
  }
}

template class NearMatrix<float>;
template class NearMatrix<double>;

}  // namespace floe::bem
