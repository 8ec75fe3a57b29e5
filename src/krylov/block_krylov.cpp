#include "krylov/block_krylov.hpp"

#include <floe/numeric/error.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <utility>

namespace floe::krylov {
namespace {

// Parts of residuals below this share of the tolerance are left out
constexpr double kNegligible = 0.01;

// An orthonormal basis of the directions of a block that its Gram matrix can tell apart, that is of
// singular values above 1e-4 of the largest after scaling the columns
MatXcd orthonormal_directions(const MatXcd& block) {
  MatXcd gram = adjoint_product<Complex>({&block, 1}, block);
  const VecXd scale = gram.diagonal().real().cwiseSqrt().cwiseInverse();
  gram = scale.asDiagonal() * gram * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatXcd> eigen(gram);
  const VecXd& value = eigen.eigenvalues();  // ascending
  const Index count = (value.array() > 1e-8 * value[value.size() - 1]).count();
  const MatXcd combination = scale.asDiagonal() * eigen.eigenvectors().rightCols(count) *
                             value.tail(count).cwiseSqrt().cwiseInverse().asDiagonal();
  const MatXcd direction = product(block, combination);

  // NOTE: small eigenvalues are known to 1e-16 of the largest only; a second time makes it right
  const MatXcd again = adjoint_product<Complex>({&direction, 1}, direction);
  const MatXcd lower = again.llt().matrixL();
  const MatXcd inverse =
      lower.adjoint().triangularView<Eigen::Upper>().solve(MatXcd::Identity(count, count));
  return product(direction, inverse);
}

MatXcd select_columns(const MatXcd& block, const std::vector<Index>& columns) {
  MatXcd selected(block.rows(), static_cast<Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j)
    selected.col(static_cast<Index>(j)) = block.col(columns[j]);
  return selected;
}

void append_rows(MatXcd& matrix, Index count) {
  const Index rows = matrix.rows();
  matrix.conservativeResize(rows + count, Eigen::NoChange);
  matrix.bottomRows(count).setZero();
}

}  // namespace

template <class Scalar>
BlockKrylov<Scalar>::BlockKrylov(MatXcd residual) : candidate_(residual.rows(), 0) {
  replace_residual(std::move(residual));
}

template <class Scalar>
void BlockKrylov<Scalar>::replace_residual(MatXcd residual) {
  rhs_ = MatXcd::Zero(rotation_.rows(), residual.cols());
  const MatXcd coordinates = absorb(residual, VecXd::Constant(residual.cols(), kNegligible));
  rhs_ = rotation_ * coordinates;
}

template <class Scalar>
VecXd BlockKrylov<Scalar>::residual_norms() const {
  return rhs_.bottomRows(rhs_.rows() - expanded_).colwise().norm().transpose();
}

template <class Scalar>
MatXcd BlockKrylov<Scalar>::choose(double threshold, Index limit) {
  const Index candidates = candidate_.cols(), tail = rhs_.rows() - expanded_;
  std::vector<Index> open;
  const VecXd norms = residual_norms();
  for (Index j = 0; j < norms.size(); ++j)
    if (norms[j] > 1.0) open.push_back(j);
  if (candidates == 0 || open.empty()) return MatXcd(candidate_.rows(), 0);

  // The residuals' coordinates along the candidates and their principal directions  (S.4)
  const MatXcd part = rotation_.bottomRightCorner(tail, candidates).adjoint() *
                      select_columns(rhs_.bottomRows(tail), open);
  const Eigen::SelfAdjointEigenSolver<MatXcd> eigen(part * part.adjoint());
  const VecXd value = eigen.eigenvalues().reverse();  // squares, descending
  const MatXcd direction = eigen.eigenvectors().rowwise().reverse();
  if (!(value[0] > 0.0)) return MatXcd(candidate_.rows(), 0);
  const double least = threshold * threshold * value[0];
  const Index count =
      std::min<Index>(limit, (value.array() >= least && value.array() > 0.0).count());

  // Turn candidates and coordinates
  candidate_ = product(candidate_, direction);
  rotation_.rightCols(candidates) *= direction;
  return candidate_.leftCols(count);
}

template <class Scalar>
void BlockKrylov<Scalar>::expand(const MatXcd& chosen, MatXcd image) {
  const Index count = chosen.cols();
  expanded_block_.push_back(chosen.template cast<Scalar>());
  candidate_ = candidate_.rightCols(candidate_.cols() - count).eval();

  // What is lost of an image is no more than rounding
  const double rounding = std::is_same_v<Scalar, Complex> ? 1e-13 : 1e-7;
  const VecXd negligible = rounding * column_norms(image);
  const MatXcd coordinates = absorb(image, negligible);
  reduce(coordinates, count);
}

// Takes the directions of V and C out of a block and returns their coordinates
template <class Scalar>
MatXcd BlockKrylov<Scalar>::project_out(MatXcd& block) const {
  MatXcd coordinates(rotation_.cols(), block.cols());
  const Index candidates = candidate_.cols();
  coordinates.topRows(expanded_columns()) = adjoint_product<Scalar>(expanded_block_, block);
  coordinates.bottomRows(candidates) = adjoint_product<Complex>({&candidate_, 1}, block);
  subtract_product<Scalar>(expanded_block_, coordinates.topRows(expanded_columns()), block);
  subtract_product<Complex>({&candidate_, 1}, coordinates.bottomRows(candidates), block);
  return coordinates;
}

template <class Scalar>
void BlockKrylov<Scalar>::append_candidates(const MatXcd& direction) {
  const Index old = candidate_.cols(), count = direction.cols(), size = rotation_.rows();
  candidate_.conservativeResize(Eigen::NoChange, old + count);
  candidate_.rightCols(count) = direction;
  MatXcd larger = MatXcd::Identity(size + count, size + count);
  larger.topLeftCorner(size, size) = rotation_;
  rotation_ = std::move(larger);
  append_rows(rhs_, count);
  append_rows(triangle_, count);
}

// Writes a block in coordinates of V and C, to which its new directions are added; parts of columns
// that are smaller than `negligible` are dropped
template <class Scalar>
MatXcd BlockKrylov<Scalar>::absorb(MatXcd& block, const VecXd& negligible) {
  MatXcd coordinates = MatXcd::Zero(rotation_.cols(), block.cols());
  for (int round = 0; round < 4; ++round) {
    // Orthogonalise; once more where that cancelled half. NOTE: leaving that to where it cancels a
    // digit lets the loss of orthogonality multiply from step to step, and the recurrence stalls
    const VecXd before = column_norms(block);
    if (rotation_.cols() > 0) {
      coordinates += project_out(block);
      const VecXd after = column_norms(block);
      if ((after.array() < 0.5 * before.array() && after.array() > negligible.array()).any())
        coordinates += project_out(block);
    }

    // Make orthonormal directions of what is left
    std::vector<Index> active;
    const VecXd norms = column_norms(block);
    for (Index j = 0; j < block.cols(); ++j)
      if (norms[j] > negligible[j]) active.push_back(j);
    if (active.empty()) break;
    const MatXcd direction = orthonormal_directions(select_columns(block, active));
    const MatXcd along = adjoint_product<Complex>({&direction, 1}, block);
    subtract_product<Complex>({&direction, 1}, along, block);
    append_candidates(direction);
    append_rows(coordinates, direction.cols());
    coordinates.bottomRows(direction.cols()) = along;
  }
  return coordinates;
}

// Householder QR of `count` further columns of H, given in coordinates of V and C  (S.3)
template <class Scalar>
void BlockKrylov<Scalar>::reduce(const MatXcd& coordinates, Index count) {
  const Index tail = rotation_.rows() - expanded_;
  const MatXcd turned = rotation_ * coordinates;
  const Eigen::HouseholderQR<MatXcd> qr(turned.bottomRows(tail));
  rotation_.bottomRows(tail).applyOnTheLeft(qr.householderQ().adjoint());
  rhs_.bottomRows(tail).applyOnTheLeft(qr.householderQ().adjoint());
  triangle_.conservativeResize(Eigen::NoChange, expanded_ + count);
  triangle_.rightCols(count).setZero();
  triangle_.topRightCorner(expanded_, count) = turned.topRows(expanded_);
  triangle_.block(expanded_, expanded_, count, count) =
      qr.matrixQR().topRows(count).template triangularView<Eigen::Upper>();
  expanded_ += count;
}

template <class Scalar>
MatXcd BlockKrylov<Scalar>::combine(Blocks<Scalar> blocks) const {
  MatXcd y = rhs_.topRows(expanded_);
  triangle_.topRows(expanded_).template triangularView<Eigen::Upper>().solveInPlace(y);
  MatXcd sum = MatXcd::Zero(candidate_.rows(), y.cols());
  subtract_product<Scalar>(blocks, -y, sum);
  return sum;
}

template class BlockKrylov<Complex>;
template class BlockKrylov<std::complex<float>>;

}  // namespace floe::krylov
