#include "krylov/tall_products.hpp"

#include <floe/numeric/blas_threads.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <vector>

extern "C" {
void zgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
            const floe::Complex* alpha, const floe::Complex* a, const int* lda,
            const floe::Complex* b, const int* ldb, const floe::Complex* beta, floe::Complex* c,
            const int* ldc);
void cgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
            const std::complex<float>* alpha, const std::complex<float>* a, const int* lda,
            const std::complex<float>* b, const int* ldb, const std::complex<float>* beta,
            std::complex<float>* c, const int* ldc);
}

namespace floe::krylov {
namespace {

using Complex32 = std::complex<float>;

// Rows that are multiplied at once: in single precision no sum is longer than this
constexpr Index kRows = 1024;

// Chunks of whole pieces of rows, at most 64 of them, so that partial sums stay few; of at least
// 256 rows, at least eight where there are rows for that, so that no thread waits for long
class Chunks {
 public:
  explicit Chunks(Index rows) : rows_(rows) {
    piece_ = std::clamp<Index>((rows + 7) / 8, 256, kRows);
    const Index pieces = (rows + piece_ - 1) / piece_;
    length_ = piece_ * std::max<Index>(1, (pieces + 63) / 64);
    count_ = (rows + length_ - 1) / length_;
  }
  Index count() const { return count_; }

  // Calls work(first row, number of rows) for the pieces of one chunk, in order
  template <class Work>
  void for_pieces(Index chunk, const Work& work) const {
    const Index last = std::min(rows_, (chunk + 1) * length_);
    for (Index first = chunk * length_; first < last; first += piece_)
      work(first, std::min(piece_, last - first));
  }

 private:
  Index rows_, piece_, length_, count_;
};

void gemm(const char* transa, Index m, Index n, Index k, Complex alpha, const Complex* a, Index lda,
          const Complex* b, Index ldb, Complex beta, Complex* c, Index ldc) {
  const int im = int(m), in = int(n), ik = int(k), ia = int(lda), ib = int(ldb), ic = int(ldc);
  zgemm_(transa, "N", &im, &in, &ik, &alpha, a, &ia, b, &ib, &beta, c, &ic);
}

void gemm(const char* transa, Index m, Index n, Index k, Complex32 alpha, const Complex32* a,
          Index lda, const Complex32* b, Index ldb, Complex32 beta, Complex32* c, Index ldc) {
  const int im = int(m), in = int(n), ik = int(k), ia = int(lda), ib = int(ldb), ic = int(ldc);
  cgemm_(transa, "N", &im, &in, &ik, &alpha, a, &ia, b, &ib, &beta, c, &ic);
}

template <class Scalar>
Index total_columns(Blocks<Scalar> v) {
  Index count = 0;
  for (const TallView<Scalar>& block : v) count += block.cols();
  return count;
}

}  // namespace

template <class Scalar>
MatXcd adjoint_product(Blocks<Scalar> v, const Eigen::Ref<const MatXcd>& w) {
  const Index n = w.rows(), rows = total_columns<Scalar>(v), columns = w.cols();
  if (rows == 0 || columns == 0) return MatXcd::Zero(rows, columns);
  numeric::use_one_blas_thread();
  const Chunks chunks(n);
  std::vector<MatXcd> partial(static_cast<std::size_t>(chunks.count()));
#pragma omp parallel for schedule(static)
  for (Index chunk = 0; chunk < chunks.count(); ++chunk) {
    MatXcd sum = MatXcd::Zero(rows, columns);
    Tall<Scalar> piece, part(rows, columns);
    chunks.for_pieces(chunk, [&](Index first, Index count) {
      piece = w.middleRows(first, count).template cast<Scalar>();
      Index row = 0;
      for (const TallView<Scalar>& block : v) {
        gemm("C", block.cols(), columns, count, Scalar(1), block.data() + first, n, piece.data(),
             count, Scalar(0), part.data() + row, rows);
        row += block.cols();
      }
      sum += part.template cast<Complex>();
    });
    partial[static_cast<std::size_t>(chunk)] = std::move(sum);
  }
  for (std::size_t chunk = 1; chunk < partial.size(); ++chunk) partial[0] += partial[chunk];
  return std::move(partial[0]);
}

template <class Scalar>
void subtract_product(Blocks<Scalar> v, const MatXcd& c, Eigen::Ref<MatXcd> w) {
  FLOE_EXPECT(total_columns<Scalar>(v) == c.rows() && c.cols() == w.cols());
  const Index n = w.rows(), inner = c.rows(), columns = w.cols();
  if (inner == 0 || columns == 0) return;
  numeric::use_one_blas_thread();
  const Tall<Scalar> factor = c.template cast<Scalar>();
  const Chunks chunks(n);
#pragma omp parallel for schedule(static)
  for (Index chunk = 0; chunk < chunks.count(); ++chunk) {
    Tall<Scalar> piece;
    chunks.for_pieces(chunk, [&](Index first, Index count) {
      piece.setZero(count, columns);
      Index row = 0;
      for (const TallView<Scalar>& block : v) {
        gemm("N", count, columns, block.cols(), Scalar(1), block.data() + first, n,
             factor.data() + row, inner, Scalar(1), piece.data(), count);
        row += block.cols();
      }
      w.middleRows(first, count) -= piece.template cast<Complex>();
    });
  }
}

template MatXcd adjoint_product(Blocks<Complex>, const Eigen::Ref<const MatXcd>&);
template MatXcd adjoint_product(Blocks<Complex32>, const Eigen::Ref<const MatXcd>&);
template void subtract_product(Blocks<Complex>, const MatXcd&, Eigen::Ref<MatXcd>);
template void subtract_product(Blocks<Complex32>, const MatXcd&, Eigen::Ref<MatXcd>);

void multiply(const Eigen::Ref<const MatXcd>& v, const MatXcd& c, Eigen::Ref<MatXcd> w) {
  FLOE_EXPECT(v.cols() == c.rows() && w.rows() == v.rows() && w.cols() == c.cols());
  const Index n = v.rows(), inner = v.cols(), columns = c.cols();
  if (inner == 0 || columns == 0) {
    w.setZero();
    return;
  }
  numeric::use_one_blas_thread();
  const Chunks chunks(n);
#pragma omp parallel for schedule(static)
  for (Index chunk = 0; chunk < chunks.count(); ++chunk)
    chunks.for_pieces(chunk, [&](Index first, Index count) {
      gemm("N", count, columns, inner, 1.0, v.data() + first, v.outerStride(), c.data(), inner, 0.0,
           w.data() + first, w.outerStride());
    });
}

template <class Scalar>
Tall<Scalar> stored(const Eigen::Ref<const MatXcd>& block) {
  Tall<Scalar> copy(block.rows(), block.cols());
#pragma omp parallel for schedule(static)
  for (Index j = 0; j < block.cols(); ++j) copy.col(j) = block.col(j).template cast<Scalar>();
  return copy;
}

template Tall<Complex> stored(const Eigen::Ref<const MatXcd>&);
template Tall<Complex32> stored(const Eigen::Ref<const MatXcd>&);

VecXd column_norms(const Eigen::Ref<const MatXcd>& w) {
  VecXd norms(w.cols());
#pragma omp parallel for schedule(static)
  for (Index j = 0; j < w.cols(); ++j) norms[j] = w.col(j).norm();
  return norms;
}

}  // namespace floe::krylov
