#include "plate/sparse_products.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace floe::plate {
namespace {

constexpr Index kBlockRows = 8192;

// NOTE: below this many rows a product takes less time than the waiting of threads at its end,
// many times less where other programs hold the processors.
constexpr Index kParallelRows = 200000;

Index block_count(Index rows) { return (rows + kBlockRows - 1) / kBlockRows; }
Index block_height(Index block, Index rows) {
  return std::min(kBlockRows, rows - block * kBlockRows);
}

// y = A x of a symmetric A: row j is column j, so that every entry is one sum of one thread
void multiply_column(const SparseMatrix& matrix, const double* x, double* y) {
  const double* const value = matrix.valuePtr();
  const auto* const row = matrix.innerIndexPtr();
  const auto* const begin = matrix.outerIndexPtr();
#pragma omp parallel for schedule(static) if (matrix.cols() >= kParallelRows)
  for (Index j = 0; j < matrix.cols(); ++j) {
    double sum = 0.0;
    for (Index e = begin[j]; e < begin[j + 1]; ++e) sum += value[e] * x[row[e]];
    y[j] = sum;
  }
}

// Whether θx and θy of each node couple as w does, times one factor
bool is_alike(const SparseMatrix& mass) {
  constexpr double kRounding = 1e-12;
  const auto* const begin = mass.outerIndexPtr();
  const double rotary = mass.valuePtr()[begin[1]] / mass.valuePtr()[begin[0]];
  for (Index column = 0; column < mass.cols(); ++column) {
    const Index first = begin[column - column % 3], count = begin[column + 1] - begin[column];
    if (count != begin[column - column % 3 + 1] - first) return false;
    // NOTE: entries that nearly cancel are only as exact as the largest of their column
    double largest = 0.0;
    for (Index k = 0; k < count; ++k)
      largest = std::max(largest, std::abs(mass.valuePtr()[first + k]));
    const double factor = column % 3 == 0 ? 1.0 : rotary;
    for (Index k = 0; k < count; ++k) {
      const Index here = begin[column] + k;
      if (mass.innerIndexPtr()[here] != mass.innerIndexPtr()[first + k] + column % 3 ||
          mass.innerIndexPtr()[first + k] % 3 != 0)
        return false;
      if (std::abs(mass.valuePtr()[here] - factor * mass.valuePtr()[first + k]) >
          kRounding * factor * largest)
        return false;
    }
  }
  return true;
}

}  // namespace

MatXd multiply_symmetric(const SparseMatrix& matrix, const Eigen::Ref<const MatXd>& x) {
  MatXd y(x.rows(), x.cols());
  for (Index c = 0; c < x.cols(); ++c) multiply_column(matrix, x.col(c).data(), y.col(c).data());
  return y;
}

NodeMass::NodeMass(const SparseMatrix& mass) : begin_(mass.cols() / 3 + 1, 0) {
  if (!is_alike(mass)) {
    general_ = mass;
    return;
  }
  const Index nodes = mass.cols() / 3;
  const auto* const begin = mass.outerIndexPtr();
  for (Index n = 0; n < nodes; ++n)
    for (Index e = begin[3 * n]; e < begin[3 * n + 1]; ++e) {
      node_.push_back(static_cast<std::int32_t>(mass.innerIndexPtr()[e] / 3));
      value_.push_back(mass.valuePtr()[e]);
      begin_[n + 1] = static_cast<Index>(node_.size());
    }
  rotary_ = mass.valuePtr()[begin[1]] / mass.valuePtr()[begin[0]];
}

void NodeMass::apply(const double* x, double* y) const {
  if (general_.size() > 0) {
    multiply_column(general_, x, y);
    return;
  }
  const Index nodes = static_cast<Index>(begin_.size()) - 1;
#pragma omp parallel for schedule(static) if (3 * nodes >= kParallelRows)
  for (Index n = 0; n < nodes; ++n) {
    double deflection = 0.0, rotation_x = 0.0, rotation_y = 0.0;
    for (Index e = begin_[n]; e < begin_[n + 1]; ++e) {
      const double* const from = x + 3 * static_cast<Index>(node_[e]);
      deflection += value_[e] * from[0];
      rotation_x += value_[e] * from[1];
      rotation_y += value_[e] * from[2];
    }
    y[3 * n] = deflection;
    y[3 * n + 1] = rotary_ * rotation_x;
    y[3 * n + 2] = rotary_ * rotation_y;
  }
}

MatXd NodeMass::operator*(const Eigen::Ref<const MatXd>& x) const {
  MatXd y(x.rows(), x.cols());
  for (Index c = 0; c < x.cols(); ++c) apply(x.col(c).data(), y.col(c).data());
  return y;
}

MatXd inner_products(const Eigen::Ref<const MatXd>& x, const Eigen::Ref<const MatXd>& y) {
  const Index blocks = block_count(x.rows());
  std::vector<MatXd> part(blocks);
#pragma omp parallel for schedule(static) if (x.rows() >= kParallelRows)
  for (Index b = 0; b < blocks; ++b) {
    const Index height = block_height(b, x.rows());
    part[b].noalias() =
        x.middleRows(b * kBlockRows, height).transpose() * y.middleRows(b * kBlockRows, height);
  }
  MatXd sum = MatXd::Zero(x.cols(), y.cols());
  for (const MatXd& p : part) sum += p;
  return sum;
}

void subtract_combination(const Eigen::Ref<const MatXd>& x, const Eigen::Ref<const MatXd>& c,
                          Eigen::Ref<MatXd> y) {
  const Index blocks = block_count(x.rows());
#pragma omp parallel for schedule(static) if (x.rows() >= kParallelRows)
  for (Index b = 0; b < blocks; ++b) {
    const Index height = block_height(b, x.rows());
    y.middleRows(b * kBlockRows, height).noalias() -= x.middleRows(b * kBlockRows, height) * c;
  }
}

void combine_columns(const Eigen::Ref<const MatXd>& c, Eigen::Ref<MatXd> x) {
  const Index blocks = block_count(x.rows());
#pragma omp parallel for schedule(static) if (x.rows() >= kParallelRows)
  for (Index b = 0; b < blocks; ++b) {
    const Index height = block_height(b, x.rows());
    const MatXd old = x.middleRows(b * kBlockRows, height);
    x.middleRows(b * kBlockRows, height).noalias() = old * c;
  }
}

}  // namespace floe::plate
