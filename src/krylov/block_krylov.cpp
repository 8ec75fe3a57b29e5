#include "krylov/block_krylov.hpp"

#include <floe/numeric/error.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <utility>

namespace floe::krylov {
namespace {

// Parts of residuals below this share of the tolerance are left out
constexpr double kNegligible = 0.01;
// Eigenvalues of a Gram matrix above this share of the largest leave directions orthogonal to 1e-13
constexpr double kWellKnown = 1e-3;

// An orthonormal basis of the directions of a block, and how it was combined of the block's columns
struct Directions {
  MatXcd basis;
  MatXcd combination;  // basis = block · combination
};

// Those that the block's Gram matrix can tell apart, that is of singular values above 1e-4 of the
// largest after scaling the columns
Directions orthonormal_directions(const MatXcd& block) {
  MatXcd gram = adjoint_product<Complex>({&block, 1}, block);
  const VecXd scale = gram.diagonal().real().cwiseSqrt().cwiseInverse();
  gram = scale.asDiagonal() * gram * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatXcd> eigen(gram);
  const VecXd& value = eigen.eigenvalues();  // ascending
  const double largest = value[value.size() - 1];
  const Index count = (value.array() > 1e-8 * largest).count();
  MatXcd combination = scale.asDiagonal() * eigen.eigenvectors().rightCols(count) *
                       value.tail(count).cwiseSqrt().cwiseInverse().asDiagonal();
  MatXcd direction = product(block, combination);
  if (value[value.size() - count] > kWellKnown * largest)
    return {std::move(direction), std::move(combination)};

  // NOTE: small eigenvalues are known to 1e-16 of the largest only; a second time makes it right
  const MatXcd again = adjoint_product<Complex>({&direction, 1}, direction);
  const MatXcd lower = again.llt().matrixL();
  const MatXcd inverse =
      lower.adjoint().triangularView<Eigen::Upper>().solve(MatXcd::Identity(count, count));
  return {product(direction, inverse), combination * inverse};
}

MatXcd select_columns(const MatXcd& block, const std::vector<Index>& columns) {
  MatXcd selected(block.rows(), static_cast<Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j)
    selected.col(static_cast<Index>(j)) = block.col(columns[j]);
  return selected;
}

// image_j -= v_j (v_j* image_j) for unit columns v_j; returns the factors
VecXcd subtract_own_part(const MatXcd& v, MatXcd& image) {
  VecXcd own(v.cols());
#pragma omp parallel for schedule(static)
  for (Index j = 0; j < v.cols(); ++j) {
    own[j] = v.col(j).dot(image.col(j));
    image.col(j) -= own[j] * v.col(j);
  }
  return own;
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

  // The most of an image of I + something is along its own direction
  const VecXcd own = subtract_own_part(chosen, image);
  MatXcd coordinates = absorb(image, negligible);
  coordinates.middleRows(expanded_columns() - count, count).diagonal() += own;
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
  VecXd norms = column_norms(block);
  for (int round = 0; round < 4 && (norms.array() > negligible.array()).any(); ++round) {
    if (rotation_.cols() > 0) {
      orthogonalise(block, norms, negligible, coordinates);
      norms = column_norms(block);
    }

    // Make orthonormal directions of what is left
    std::vector<Index> active;
    for (Index j = 0; j < block.cols(); ++j)
      if (norms[j] > negligible[j]) active.push_back(j);
    if (active.empty()) break;
    const bool whole = static_cast<Index>(active.size()) == block.cols();
    const Directions made = orthonormal_directions(whole ? block : select_columns(block, active));
    const Index count = made.basis.cols();
    append_candidates(made.basis);
    append_rows(coordinates, count);
    if (whole && count == block.cols()) {  // nothing remains
      coordinates.bottomRows(count) = made.combination.inverse();
      break;
    }
    coordinates.bottomRows(count) = adjoint_product<Complex>({&made.basis, 1}, block);
    subtract_product<Complex>({&made.basis, 1}, coordinates.bottomRows(count), block);
    norms = column_norms(block);
  }
  return coordinates;
}

// Takes the directions of V and C out of a block, once more from columns of which that cancelled
// half. NOTE: leaving that to where it cancels a digit lets the loss of orthogonality multiply from
// step to step, and the recurrence stalls
template <class Scalar>
void BlockKrylov<Scalar>::orthogonalise(MatXcd& block, const VecXd& before, const VecXd& negligible,
                                        MatXcd& coordinates) const {
  coordinates += project_out(block);
  const VecXd after = column_norms(block);
  std::vector<Index> cancelled;
  for (Index j = 0; j < block.cols(); ++j)
    if (after[j] < 0.5 * before[j] && after[j] > negligible[j]) cancelled.push_back(j);
  if (cancelled.empty()) return;
  MatXcd part = select_columns(block, cancelled);
  const MatXcd more = project_out(part);
  for (std::size_t i = 0; i < cancelled.size(); ++i) {
    coordinates.col(cancelled[i]) += more.col(static_cast<Index>(i));
    block.col(cancelled[i]) = part.col(static_cast<Index>(i));
  }
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
