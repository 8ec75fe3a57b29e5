#include "plate/shifted_factor.hpp"

#include <floe/numeric/error.hpp>

#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace floe::plate {
namespace {

// Keeps CHOLMOD to the calling thread while it lives.
// NOTE: CHOLMOD opens two regions of four threads a supernode for sums of little work. Where other
// programs hold the processors, their barriers take several times as long as all the rest.
class SingleThread final {
 public:
  SingleThread() : levels_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
  ~SingleThread() { omp_set_max_active_levels(levels_); }
  SingleThread(const SingleThread&) = delete;
  SingleThread& operator=(const SingleThread&) = delete;

 private:
  int levels_;
};

}  // namespace

static_assert(sizeof(SuiteSparse_long) == sizeof(Index));

// CHOLMOD's settings and objects, released together
struct ShiftedFactor::Cholmod {
  cholmod_common common{};
  cholmod_sparse* matrix = nullptr;
  cholmod_factor* factor = nullptr;
  cholmod_dense* solution = nullptr;
  cholmod_dense* work = nullptr;
  cholmod_dense* more_work = nullptr;

  Cholmod() {
    cholmod_l_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
  }
  ~Cholmod() {
    cholmod_l_free_sparse(&matrix, &common);
    cholmod_l_free_factor(&factor, &common);
    cholmod_l_free_dense(&solution, &common);
    cholmod_l_free_dense(&work, &common);
    cholmod_l_free_dense(&more_work, &common);
    cholmod_l_finish(&common);
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;

  void check(Index unknowns) const {
    FLOE_VALIDATE_AS(
        BudgetError, common.status != CHOLMOD_OUT_OF_MEMORY,
        "not enough memory to factor the plate's stiffness, " << unknowns << " unknowns");
    FLOE_VALIDATE_AS(BudgetError, common.status != CHOLMOD_TOO_LARGE,
                     "factor of the plate's stiffness is too large, " << unknowns << " unknowns");
    FLOE_VALIDATE_AS(ConvergenceError, common.status != CHOLMOD_NOT_POSDEF,
                     "shifted stiffness of the plate is not positive definite at unknown "
                         << factor->minor << " of " << unknowns);
    FLOE_VALIDATE_AS(ConvergenceError, common.status >= CHOLMOD_OK,
                     "factorisation of the plate's stiffness failed, status = " << common.status);
  }

  Index* columns(cholmod_sparse* sparse) const { return static_cast<Index*>(sparse->p); }
  Index* rows(cholmod_sparse* sparse) const { return static_cast<Index*>(sparse->i); }

  void make_matrix(const PlateMatrices& plate, double shift);
  std::vector<Index> order_nodes(const SparseMatrix& stiffness);
};

// The lower triangle of K + sM
void ShiftedFactor::Cholmod::make_matrix(const PlateMatrices& plate, double shift) {
  const SparseMatrix &k = plate.stiffness, &m = plate.mass;
  const Index size = k.cols();
  const auto first_below = [&](Index column) {
    const Index* const begin = k.innerIndexPtr() + k.outerIndexPtr()[column];
    const Index* const end = k.innerIndexPtr() + k.outerIndexPtr()[column + 1];
    return std::lower_bound(begin, end, column) - k.innerIndexPtr();
  };
  Index count = 0;
  for (Index j = 0; j < size; ++j) count += k.outerIndexPtr()[j + 1] - first_below(j);
  matrix = cholmod_l_allocate_sparse(size, size, count, 1, 1, -1, CHOLMOD_REAL, &common);
  check(size);

  Index* const p = columns(matrix);
  Index* const i = rows(matrix);
  double* const x = static_cast<double*>(matrix->x);
  p[0] = 0;
  for (Index j = 0; j < size; ++j) {
    const Index first = first_below(j), height = k.outerIndexPtr()[j + 1] - first;
    std::copy_n(k.innerIndexPtr() + first, height, i + p[j]);
    std::copy_n(k.valuePtr() + first, height, x + p[j]);
    p[j + 1] = p[j] + height;
    Index here = p[j];
    for (Index e = m.outerIndexPtr()[j]; e < m.outerIndexPtr()[j + 1]; ++e) {
      if (m.innerIndexPtr()[e] < j) continue;
      while (i[here] < m.innerIndexPtr()[e]) ++here;
      x[here] += shift * m.valuePtr()[e];
    }
  }
}

// Nested dissection of the graph of nodes, a ninth of the entries of K: all three unknowns of a
// node have the same neighbours
std::vector<Index> ShiftedFactor::Cholmod::order_nodes(const SparseMatrix& stiffness) {
  const Index nodes = stiffness.cols() / kUnknownsPerNode;
  cholmod_sparse* graph = cholmod_l_allocate_sparse(nodes, nodes, stiffness.nonZeros() / 9, 1, 1,
                                                    -1, CHOLMOD_PATTERN, &common);
  check(stiffness.cols());
  Index count = 0;
  for (Index j = 0; j < nodes; ++j) {
    columns(graph)[j] = count;
    const Index end = stiffness.outerIndexPtr()[3 * j + 1];
    for (Index e = stiffness.outerIndexPtr()[3 * j]; e < end; e += 3)
      rows(graph)[count++] = stiffness.innerIndexPtr()[e] / 3;
  }
  columns(graph)[nodes] = count;

  std::vector<Index> order(nodes);
  if (!cholmod_l_metis(graph, nullptr, 0, 1, order.data(), &common))
    cholmod_l_amd(graph, nullptr, 0, order.data(), &common);
  cholmod_l_free_sparse(&graph, &common);
  check(stiffness.cols());
  return order;
}

ShiftedFactor::ShiftedFactor(const PlateMatrices& plate, double shift)
    : cholmod_(std::make_unique<Cholmod>()) {
  Cholmod& c = *cholmod_;
  const Index unknowns = plate.stiffness.cols();

  // Order the unknowns node by node
  const std::vector<Index> node_order = c.order_nodes(plate.stiffness);
  std::vector<Index> order(unknowns);
  for (std::size_t n = 0; n < node_order.size(); ++n)
    for (int r = 0; r < kUnknownsPerNode; ++r)
      order[kUnknownsPerNode * n + r] = kUnknownsPerNode * node_order[n] + r;

  // Analyse and factor
  c.make_matrix(plate, shift);
  c.factor = cholmod_l_analyze_p(c.matrix, order.data(), nullptr, 0, &c.common);
  c.check(unknowns);
  {
    const SingleThread single;
    cholmod_l_factorize(c.matrix, c.factor, &c.common);
  }
  c.check(unknowns);
  cholmod_l_free_sparse(&c.matrix, &c.common);
}

ShiftedFactor::~ShiftedFactor() = default;
ShiftedFactor::ShiftedFactor(ShiftedFactor&&) noexcept = default;
ShiftedFactor& ShiftedFactor::operator=(ShiftedFactor&&) noexcept = default;

Index ShiftedFactor::size() const { return static_cast<Index>(cholmod_->factor->n); }
Index ShiftedFactor::entry_count() const { return static_cast<Index>(cholmod_->factor->xsize); }

// A view of CHOLMOD's own solution, valid until the next one
template <typename Columns>
Eigen::Map<const Columns> ShiftedFactor::solution_of(const Eigen::Ref<const Columns>& rhs,
                                                     int type) const {
  FLOE_EXPECT(rhs.rows() == size());
  Cholmod& c = *cholmod_;
  cholmod_dense b{};
  b.nrow = rhs.rows();
  b.ncol = rhs.cols();
  b.d = rhs.outerStride();
  b.nzmax = b.d * b.ncol;
  b.x = const_cast<typename Columns::Scalar*>(rhs.data());  // read only
  b.xtype = type;
  b.dtype = CHOLMOD_DOUBLE;
  cholmod_l_solve2(CHOLMOD_A, c.factor, &b, nullptr, &c.solution, nullptr, &c.work, &c.more_work,
                   &c.common);
  c.check(size());
  return {static_cast<const typename Columns::Scalar*>(c.solution->x), rhs.rows(), rhs.cols()};
}

void ShiftedFactor::solve(const Eigen::Ref<const MatXd>& rhs, Eigen::Ref<MatXd> x) const {
  FLOE_EXPECT(x.rows() == size() && x.cols() == rhs.cols());
  x = solution_of<MatXd>(rhs, CHOLMOD_REAL);
}

MatXcd ShiftedFactor::solve(const Eigen::Ref<const MatXcd>& rhs) const {
  return solution_of<MatXcd>(rhs, CHOLMOD_COMPLEX);
}

}  // namespace floe::plate
