#include <floe/numeric/blas_threads.hpp>
#include <floe/numeric/dense_lu.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>

extern "C" {
void zgetrf_(const int* m, const int* n, floe::Complex* a, const int* lda, int* ipiv, int* info);
void zlaswp_(const int* n, floe::Complex* a, const int* lda, const int* k1, const int* k2,
             const int* ipiv, const int* incx);
void ztrsm_(const char* side, const char* uplo, const char* transa, const char* diag, const int* m,
            const int* n, const floe::Complex* alpha, const floe::Complex* a, const int* lda,
            floe::Complex* b, const int* ldb);
void zgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
            const floe::Complex* alpha, const floe::Complex* a, const int* lda,
            const floe::Complex* b, const int* ldb, const floe::Complex* beta, floe::Complex* c,
            const int* ldc);
}

namespace floe::numeric {
namespace {

constexpr int kPanel = 96;  // columns factored at once
constexpr int kTile = 192;  // columns updated by one thread at a time

const Complex kOne(1.0, 0.0), kMinusOne(-1.0, 0.0);

// Swaps rows first … last-1 of `columns` columns as the pivots say
void swap_rows(Complex* columns, int count, int rows, int first, int last, const int* pivots) {
  const int from = first + 1, stride = 1;
  zlaswp_(&count, columns, &rows, &from, &last, pivots, &stride);
}

// Applies the panel's columns first … last-1 to the tile `columns`: pivots, U block, remainder
void update_tile(const MatXcd& panel, Complex* columns, int count, int first, int last,
                 const int* pivots) {
  const int rows = static_cast<int>(panel.rows()), width = last - first, below = rows - last;
  const Complex* diagonal = panel.data() + first + static_cast<Index>(first) * rows;
  swap_rows(columns, count, rows, first, last, pivots);
  ztrsm_("L", "L", "N", "U", &width, &count, &kOne, diagonal, &rows, columns + first, &rows);
  if (below > 0)
    zgemm_("N", "N", &below, &count, &width, &kMinusOne, diagonal + width, &rows, columns + first,
           &rows, &kOne, columns + last, &rows);
}

}  // namespace

DenseLu::DenseLu(MatXcd matrix) : factors_(std::move(matrix)), pivots_(factors_.rows()) {
  FLOE_EXPECT(factors_.rows() == factors_.cols());
  use_one_blas_thread();
  const int n = static_cast<int>(factors_.rows());
  for (int first = 0; first < n; first += kPanel) {
    // Factor the panel; LAPACK counts its pivots from the panel's first row
    const int last = std::min(first + kPanel, n), rows = n - first, width = last - first;
    int info = 0;
    zgetrf_(&rows, &width, factors_.data() + first + static_cast<Index>(first) * n, &n,
            pivots_.data() + first, &info);
    FLOE_VALIDATE_AS(ConvergenceError, info == 0,
                     "singular matrix: pivot " << first + std::abs(info) << " of " << n
                                               << " is zero (must not be)");
    for (int i = first; i < last; ++i) pivots_[i] += first;

    // Swap the rows of the finished columns, update all columns to the right
    const int tiles = (n - last + kTile - 1) / kTile;
#pragma omp parallel for schedule(dynamic, 1)
    for (int tile = -1; tile < tiles; ++tile) {
      if (tile < 0) {
        swap_rows(factors_.data(), first, n, first, last, pivots_.data());
        continue;
      }
      const int column = last + tile * kTile;
      update_tile(factors_, factors_.data() + static_cast<Index>(column) * n,
                  std::min(kTile, n - column), first, last, pivots_.data());
    }
  }
}

void DenseLu::solve(Eigen::Ref<MatXcd> rhs) const {
  FLOE_EXPECT(rhs.rows() == factors_.rows());
  use_one_blas_thread();
  const int n = static_cast<int>(factors_.rows()), stride = static_cast<int>(rhs.outerStride());
  constexpr int kColumns = 8;
  const int blocks = static_cast<int>((rhs.cols() + kColumns - 1) / kColumns);
#pragma omp parallel for schedule(dynamic, 1)
  for (int block = 0; block < blocks; ++block) {
    const int first = block * kColumns;
    const int count = std::min<int>(kColumns, static_cast<int>(rhs.cols()) - first);
    Complex* columns = rhs.data() + static_cast<Index>(first) * stride;
    const int from = 1, step = 1;
    zlaswp_(&count, columns, &stride, &from, &n, pivots_.data(), &step);
    ztrsm_("L", "L", "N", "U", &n, &count, &kOne, factors_.data(), &n, columns, &stride);
    ztrsm_("L", "U", "N", "N", &n, &count, &kOne, factors_.data(), &n, columns, &stride);
  }
}

}  // namespace floe::numeric
