#include <floe/numeric/blas_check.hpp>
#include <floe/numeric/dense_lu.hpp>
#include <floe/numeric/error.hpp>
#include <floe/numeric/simd.hpp>

#include <dlfcn.h>
#include <omp.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <cmath>
#include <utility>

extern "C" {
void dgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
            const double* alpha, const double* a, const int* lda, const double* b, const int* ldb,
            const double* beta, double* c, const int* ldc);
void zgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
            const floe::Complex* alpha, const floe::Complex* a, const int* lda,
            const floe::Complex* b, const int* ldb, const floe::Complex* beta, floe::Complex* c,
            const int* ldc);
}

namespace floe::numeric {
namespace {

// Sizes that no kernel's blocks divide
constexpr int kRows = 67, kInner = 131, kColumns = 43;
// Sums of 131 products of numbers below 1
constexpr double kLimit = 1e-12;
constexpr std::size_t kBufferSize = 160'000'000;  // of a thread: 128 MiB and its stack

// Numbers between -1 and 1 that repeat nowhere
template <typename Matrix>
Matrix varied(int rows, int columns, double seed) {
  Matrix matrix(rows, columns);
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i) matrix(i, j) = std::sin(seed + 12.9898 * i + 78.233 * j);
  return matrix;
}

// C = A B by the definition
template <typename Matrix>
Matrix plain_product(const Matrix& a, const Matrix& b) {
  Matrix c = Matrix::Zero(a.rows(), b.cols());
  for (Index j = 0; j < b.cols(); ++j)
    for (Index l = 0; l < a.cols(); ++l)
      for (Index i = 0; i < a.rows(); ++i) c(i, j) += a(i, l) * b(l, j);
  return c;
}

double error_of_real_product() {
  const MatXd a = varied<MatXd>(kRows, kInner, 0.3), b = varied<MatXd>(kInner, kColumns, 0.7);
  MatXd c(kRows, kColumns);
  const double one = 1.0, zero = 0.0;
  c.setZero();
  dgemm_("N", "N", &kRows, &kColumns, &kInner, &one, a.data(), &kRows, b.data(), &kInner, &zero,
         c.data(), &kRows);
  return (c - plain_product(a, b)).cwiseAbs().maxCoeff();
}

MatXcd complex_matrix(int rows, int columns, double seed) {
  MatXcd matrix(rows, columns);
  matrix.real() = varied<MatXd>(rows, columns, seed);
  matrix.imag() = varied<MatXd>(rows, columns, seed + 0.1);
  return matrix;
}

double error_of_complex_product() {
  const MatXcd a = complex_matrix(kRows, kInner, 0.3), b = complex_matrix(kInner, kColumns, 0.7);
  MatXcd c = MatXcd::Zero(kRows, kColumns);
  const Complex one = 1.0, zero = 0.0;
  zgemm_("N", "N", &kRows, &kColumns, &kInner, &one, a.data(), &kRows, b.data(), &kInner, &zero,
         c.data(), &kRows);
  return (c - plain_product(a, b)).cwiseAbs().maxCoeff();
}

// Residual of a well-conditioned system, relative to its unknowns of size 1
double error_of_solution() {
  MatXcd matrix = complex_matrix(kInner, kInner, 0.2);
  matrix.diagonal().array() += 4.0 * std::sqrt(static_cast<double>(kInner));
  MatXcd x = complex_matrix(kInner, kColumns, 0.9);
  const MatXcd right = plain_product(matrix, x);
  MatXcd solved = right;
  DenseLu(matrix).solve(solved);
  return (solved - x).cwiseAbs().maxCoeff();
}

}  // namespace

namespace {

// What a function of OpenBLAS tells; "" where the BLAS is another one
std::string told_by(const char* function) {
  using Teller = char* (*)();
  void* const symbol = dlsym(RTLD_DEFAULT, function);
  return symbol ? reinterpret_cast<Teller>(symbol)() : "";
}

}  // namespace

std::string blas_name() {
  const std::string name = told_by("openblas_get_config");
  const std::string core = told_by("openblas_get_corename");
  return (name.empty() ? "unknown" : name) + (core.empty() ? "" : " (" + core + ")");
}

std::string processor_kind() {
  const std::string core = told_by("openblas_get_corename");
  return (core.empty() ? "unknown" : core) +
         (has_wide_vectors() ? ", 64-byte vectors" : ", 32-byte vectors");
}

namespace {

// OpenBLAS maps a buffer for each thread that multiplies, and asks for ever where it may not
void require_buffers(int threads) {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  const std::size_t size = static_cast<std::size_t>(threads) * kBufferSize;
  void* const probe = mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  FLOE_VALIDATE_AS(
      BudgetError, probe != MAP_FAILED,
      "invalid address space = " << limit.rlim_cur / 1000000 << " MB (must leave " << size / 1000000
                                 << " MB for the linear algebra, " << kBufferSize / 1000000
                                 << " MB a thread; raise `ulimit -v` or take fewer threads)");
  munmap(probe, size);
}

}  // namespace

void require_working_blas() {
  require_buffers(omp_get_max_threads());
  const std::pair<const char*, double> tests[] = {{"real product", error_of_real_product()},
                                                  {"complex product", error_of_complex_product()},
                                                  {"complex solution", error_of_solution()}};
  for (const auto& [what, error] : tests)
    FLOE_VALIDATE_AS(Error, error <= kLimit,
                     "the BLAS library computes wrongly: error of a "
                         << what << " = " << error << " (must be at most " << kLimit << ") by "
                         << blas_name()
                         << "; install another one, or name this processor in OPENBLAS_CORETYPE");
}

}  // namespace floe::numeric
