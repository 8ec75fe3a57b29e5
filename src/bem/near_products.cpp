#include "bem/near_products.hpp"

#include <floe/numeric/simd.hpp>

#include <algorithm>

namespace floe::bem {
namespace {

// Sums of one row are kept in kLanes parts, entry k in part k mod kLanes, whatever the number of
// columns, and each product is added by itself, so that a fused multiply-add can be made in one way
// only: a column has the same bits alone and among others
constexpr int kLanes = 4;

// sum (re, im) of one row for one column; gathered holds re, im of each column entry
// Inlined into the clones below, or they would be compiled for the least of all processors
#define FLOE_INLINE __attribute__((always_inline)) inline

template <class Real>
FLOE_INLINE void sum_row(const Real* value, const std::uint16_t* column, std::size_t count,
                         const double* gathered, double* sum) {
  double re[kLanes] = {}, im[kLanes] = {};
  std::size_t k = 0;
  for (; k + kLanes <= count; k += kLanes)
    for (int lane = 0; lane < kLanes; ++lane) {
      const double a = value[k + lane];
      const double* x = gathered + 2 * column[k + lane];
      re[lane] += a * x[0];
      im[lane] += a * x[1];
    }
  for (int lane = 0; k < count; ++k, ++lane) {
    const double a = value[k];
    const double* x = gathered + 2 * column[k];
    re[lane] += a * x[0];
    im[lane] += a * x[1];
  }
  sum[0] = (re[0] + re[1]) + (re[2] + re[3]);
  sum[1] = (im[0] + im[1]) + (im[2] + im[3]);
}

template <int kColumns>
struct Vectors {
  using Type __attribute__((vector_size(8 * kColumns), aligned(8))) = double;
};
template <int kColumns>
using Vector = typename Vectors<kColumns>::Type;

// The same for kColumns of kNearColumns columns; gathered holds all re, then all im, of each column
// entry, and so does sum
template <int kColumns, class Real>
FLOE_INLINE void sum_row_of_many(const Real* value, const std::uint16_t* column, std::size_t count,
                                 const double* gathered, double* sum) {
  using V = Vector<kColumns>;
  V re[kLanes] = {}, im[kLanes] = {};
  const auto add = [&](std::size_t k, int lane) __attribute__((always_inline)) {
    const double a = value[k];
    const double* const at = gathered + 2 * kNearColumns * column[k];
    re[lane] += a * *reinterpret_cast<const V*>(at);
    im[lane] += a * *reinterpret_cast<const V*>(at + kNearColumns);
  };
  std::size_t k = 0;
  for (; k + kLanes <= count; k += kLanes)
    for (int lane = 0; lane < kLanes; ++lane) add(k + lane, lane);
  for (int lane = 0; k < count; ++k, ++lane) add(k, lane);
  *reinterpret_cast<V*>(sum) = (re[0] + re[1]) + (re[2] + re[3]);
  *reinterpret_cast<V*>(sum + kNearColumns) = (im[0] + im[1]) + (im[2] + im[3]);
}

// NOTE: eight columns in one vector where that is a register; elsewhere their sixteen sums would
// take twice the registers that there are
template <class Real>
FLOE_INLINE void sum_rows(const NearPattern& pattern, Index first, Index last, const Real* value,
                          const double* gathered, Index columns, bool wide, double* sums) {
  constexpr int kHalf = kNearColumns / 2;
  for (Index row = first; row < last; ++row) {
    const std::size_t begin = pattern.entry_begin(row);
    const std::size_t count = pattern.entry_begin(row + 1) - begin;
    double* const sum = sums + 2 * columns * (row - first);
    const Real* const values = value + begin;
    const std::uint16_t* const entries = pattern.entry_column() + begin;
    if (columns == 1) {
      sum_row(values, entries, count, gathered, sum);
    } else if (wide) {
      sum_row_of_many<kNearColumns>(values, entries, count, gathered, sum);
    } else {
      sum_row_of_many<kHalf>(values, entries, count, gathered, sum);
      sum_row_of_many<kHalf>(values, entries, count, gathered + kHalf, sum + kHalf);
    }
  }
}

FLOE_SIMD_CLONES void sum_block(const NearPattern& pattern, Index first, Index last,
                                const float* value, const double* gathered, Index columns,
                                bool wide, double* sums) {
  sum_rows(pattern, first, last, value, gathered, columns, wide, sums);
}

FLOE_SIMD_CLONES void sum_block(const NearPattern& pattern, Index first, Index last,
                                const double* value, const double* gathered, Index columns,
                                bool wide, double* sums) {
  sum_rows(pattern, first, last, value, gathered, columns, wide, sums);
}

}  // namespace

template <class Real>
void add_near_block(const NearPattern& pattern, Index block, const Real* value,
                    const Eigen::Ref<const MatXcd>& x, double scale, std::vector<double>& gathered,
                    Eigen::Ref<MatXcd> y) {
  // Gather what the rows refer to
  const Index columns = x.cols();
  const auto nodes = pattern.columns(block);
  gathered.resize(2 * static_cast<std::size_t>(columns) * nodes.size());
  for (Index column = 0; column < columns; ++column) {
    const Complex* const from = x.col(column).data();
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      gathered[2 * columns * k + column] = from[nodes[k]].real();
      gathered[2 * columns * k + columns + column] = from[nodes[k]].imag();
    }
  }

  // Multiply, and add where the targets are
  const Index first = block * NearPattern::kBlockRows;
  const Index last = std::min(pattern.rows(), first + NearPattern::kBlockRows);
  double sums[2 * kNearColumns * NearPattern::kBlockRows];
  sum_block(pattern, first, last, value, gathered.data(), columns, numeric::has_wide_vectors(),
            sums);
  for (Index column = 0; column < columns; ++column)
    for (Index row = first; row < last; ++row) {
      const double* sum = sums + 2 * columns * (row - first) + column;
      y(pattern.target(row), column) += scale * Complex(sum[0], sum[columns]);
    }
}

template void add_near_block<float>(const NearPattern&, Index, const float*,
                                    const Eigen::Ref<const MatXcd>&, double, std::vector<double>&,
                                    Eigen::Ref<MatXcd>);
template void add_near_block<double>(const NearPattern&, Index, const double*,
                                     const Eigen::Ref<const MatXcd>&, double, std::vector<double>&,
                                     Eigen::Ref<MatXcd>);

#undef FLOE_INLINE

}  // namespace floe::bem
