#include "bem/near_matrix.hpp"

#include "bem/near_products.hpp"
#include "bem/near_rows.hpp"

#include <floe/numeric/error.hpp>

#include <algorithm>
#include <cmath>

namespace floe::bem {
namespace {

using Integrals = std::vector<std::array<Complex, 8>>;

// The exact integrals of one pair of each kind
Integrals integrate_kinds(const NearPattern& pattern, const ElementIntegrals& integrals,
                          const green::GreenTable& green) {
  const auto& kinds = pattern.kinds();
  Integrals exact(kinds.size());
#pragma omp parallel for schedule(dynamic, 8)
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const Index element = kinds[k].element;
    integrals.node_elements(kinds[k].node, {&element, 1}, green, {&exact[k], 1});
  }
  return exact;
}

}  // namespace

template <class Real>
NearMatrix<Real>::NearMatrix(const NearPattern& pattern, const ElementIntegrals& integrals,
                             const SourceRule& rule, const fmm::KernelSum& sum,
                             const green::GreenTable& green)
    : value_(2 * pattern.entry_count()) {
  // Where pairs are equal they are integrated once; else row by row, many at a time
  const bool shared = 2 * pattern.kinds().size() < pattern.pair_count();
  const Integrals exact = shared ? integrate_kinds(pattern, integrals, green) : Integrals();
  bool finite = true;
#pragma omp parallel reduction(&& : finite)
  {
    NearRow row(pattern, integrals, rule, sum, green);
#pragma omp for schedule(dynamic, 4)
    for (Index block = 0; block < pattern.blocks(); ++block) {
      const Index first = block * NearPattern::kBlockRows;
      const Index last = std::min(pattern.rows(), first + NearPattern::kBlockRows);
      for (Index i = first; i < last; ++i) {
        const std::vector<Complex>& values = row.values(block, i, exact);
        Real* const at = value_.data() + 2 * pattern.entry_begin(i);
        for (std::size_t k = 0; k < values.size(); ++k) {
          finite = finite && std::isfinite(values[k].real()) && std::isfinite(values[k].imag());
          at[2 * k] = static_cast<Real>(values[k].real());
          at[2 * k + 1] = static_cast<Real>(values[k].imag());
        }
      }
    }
  }
  FLOE_VALIDATE_AS(ConvergenceError, finite,
                   "near field has an entry that is not finite at nu = " << green.exact().nu());
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
