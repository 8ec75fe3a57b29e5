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

// How directions are combined of a block's columns: directions = block · combination
struct Combination {
  MatXcd factors;
  bool exact;  // whether they come out orthonormal to 1e-13
};

// Those that the block's Gram matrix can tell apart, that is of singular values above 1e-4 of the
// largest after scaling the columns
Combination orthonormal_combination(MatXcd gram) {
  const Index columns = gram.cols();
  const VecXd scale = gram.diagonal().real().cwiseSqrt().cwiseInverse();
  gram = scale.asDiagonal() * gram * scale.asDiagonal();

  // Cheap where the columns are far from dependent: 1/‖L⁻¹‖² is below the smallest eigenvalue, the
  // trace above the largest
  if (const Eigen::LLT<MatXcd> cholesky(gram); cholesky.info() == Eigen::Success) {
    MatXcd inverse = MatXcd::Identity(columns, columns);
    cholesky.matrixU().solveInPlace(inverse);
    if (double(columns) * inverse.squaredNorm() < 1.0 / kWellKnown)
      return {scale.asDiagonal() * inverse, true};
  }

  const Eigen::SelfAdjointEigenSolver<MatXcd> eigen(gram);
  const VecXd& value = eigen.eigenvalues();  // ascending
  const double largest = value[value.size() - 1];
  const Index count = (value.array() > 1e-8 * largest).count();
  return {scale.asDiagonal() * eigen.eigenvectors().rightCols(count) *
              value.tail(count).cwiseSqrt().cwiseInverse().asDiagonal(),
          value[value.size() - count] > kWellKnown * largest};
}

void copy_columns(const Eigen::Ref<const MatXcd>& from, const std::vector<Index>& columns,
                  Eigen::Ref<MatXcd> to) {
#pragma omp parallel for schedule(static)
  for (std::size_t j = 0; j < columns.size(); ++j)
    to.col(static_cast<Index>(j)) = from.col(columns[j]);
}

// image_j -= v_j (v_j* image_j) for unit columns v_j; returns the factors
VecXcd subtract_own_part(const Eigen::Ref<const MatXcd>& v, Eigen::Ref<MatXcd> image) {
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
void BlockKrylov<Scalar>::replace_residual(Eigen::Ref<MatXcd> residual) {
  rhs_ = MatXcd::Zero(rotation_.rows(), residual.cols());
  const MatXcd coordinates = absorb(residual, VecXd::Constant(residual.cols(), kNegligible));
  rhs_ = rotation_ * coordinates;
}

template <class Scalar>
VecXd BlockKrylov<Scalar>::residual_norms() const {
  return rhs_.bottomRows(rhs_.rows() - expanded_).colwise().norm().transpose();
}

template <class Scalar>
Index BlockKrylov<Scalar>::choose(double threshold, Index limit) {
  const Index tail = rhs_.rows() - expanded_;
  std::vector<Index> open;
  const VecXd norms = residual_norms();
  for (Index j = 0; j < norms.size(); ++j)
    if (norms[j] > 1.0) open.push_back(j);
  if (candidates_ == 0 || open.empty()) return 0;

  // The residuals' coordinates along the candidates and their principal directions  (S.4)
  const MatXcd residual = rhs_.bottomRows(tail)(Eigen::all, open);
  const MatXcd part = rotation_.bottomRightCorner(tail, candidates_).adjoint() * residual;
  const Eigen::SelfAdjointEigenSolver<MatXcd> eigen(part * part.adjoint());
  const VecXd value = eigen.eigenvalues().reverse();  // squares, descending
  const MatXcd direction = eigen.eigenvectors().rowwise().reverse();
  if (!(value[0] > 0.0)) return 0;
  const double least = threshold * threshold * value[0];

  // Turn candidates and coordinates
  multiply(candidates(), direction, spare(candidates_));
  candidate_.swap(spare_);
  rotation_.rightCols(candidates_) *= direction;
  return std::min<Index>(limit, (value.array() >= least && value.array() > 0.0).count());
}

template <class Scalar>
void BlockKrylov<Scalar>::expand(Eigen::Ref<MatXcd> image) {
  // What is lost of an image is no more than rounding
  const double rounding = std::is_same_v<Scalar, Complex> ? 1e-13 : 1e-7;
  const VecXd negligible = rounding * column_norms(image);

  // The most of an image of I + something is along its own direction
  const Index count = image.cols();
  const VecXcd own = subtract_own_part(chosen(count), image);
  expanded_block_.push_back(stored<Scalar>(chosen(count)));
  candidates_ -= count;
  for (Index j = 0; j < candidates_; ++j) candidate_.col(j) = candidate_.col(count + j);

  MatXcd coordinates = absorb(image, negligible);
  coordinates.middleRows(expanded_columns() - count, count).diagonal() += own;
  reduce(coordinates, count);
}

// Takes the directions of V and C out of a block and returns their coordinates
template <class Scalar>
MatXcd BlockKrylov<Scalar>::project_out(Eigen::Ref<MatXcd> block) const {
  MatXcd coordinates(rotation_.cols(), block.cols());
  const std::vector<TallView<Scalar>> v = views<Scalar>(expanded_block_);
  const TallView<Complex> c = candidates_view();
  coordinates.topRows(expanded_columns()) = adjoint_product<Scalar>(v, block);
  coordinates.bottomRows(candidates_) = adjoint_product<Complex>({&c, 1}, block);
  subtract_product<Scalar>(v, coordinates.topRows(expanded_columns()), block);
  subtract_product<Complex>({&c, 1}, coordinates.bottomRows(candidates_), block);
  return coordinates;
}

template <class Scalar>
Eigen::Ref<MatXcd> BlockKrylov<Scalar>::spare(Index columns) {
  if (spare_.cols() < columns) spare_.resize(spare_.rows(), columns);
  return spare_.leftCols(columns);
}

// Room for further candidates, which the caller fills
template <class Scalar>
Eigen::Ref<MatXcd> BlockKrylov<Scalar>::append_candidates(Index count) {
  const Index size = rotation_.rows();
  if (candidate_.cols() < candidates_ + count)
    candidate_.conservativeResize(Eigen::NoChange, candidates_ + count);
  candidates_ += count;
  MatXcd larger = MatXcd::Identity(size + count, size + count);
  larger.topLeftCorner(size, size) = rotation_;
  rotation_ = std::move(larger);
  append_rows(rhs_, count);
  append_rows(triangle_, count);
  return candidate_.middleCols(candidates_ - count, count);
}

// Adds an orthonormal basis of a block's directions to the candidates; returns how it is combined
// of the block's columns
template <class Scalar>
MatXcd BlockKrylov<Scalar>::append_orthonormal(const Eigen::Ref<const MatXcd>& block) {
  const auto gram = [](const Eigen::Ref<const MatXcd>& columns) {
    const TallView<Complex> view(columns.data(), columns.rows(), columns.cols());
    return adjoint_product<Complex>({&view, 1}, columns);
  };
  Combination combination = orthonormal_combination(gram(block));
  const Index count = combination.factors.cols();
  Eigen::Ref<MatXcd> basis = append_candidates(count);
  multiply(block, combination.factors, basis);
  if (combination.exact) return std::move(combination.factors);

  // NOTE: small eigenvalues are known to 1e-16 of the largest only; a second time makes it right
  const MatXcd lower = gram(basis).llt().matrixL();
  const MatXcd inverse =
      lower.adjoint().triangularView<Eigen::Upper>().solve(MatXcd::Identity(count, count));
  Eigen::Ref<MatXcd> again = spare(count);
  multiply(basis, inverse, again);
  basis = again;
  return combination.factors * inverse;
}

// Writes a block in coordinates of V and C, to which its new directions are added; parts of columns
// that are smaller than `negligible` are dropped
template <class Scalar>
MatXcd BlockKrylov<Scalar>::absorb(Eigen::Ref<MatXcd> block, const VecXd& negligible) {
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
    Eigen::Ref<MatXcd> part = whole ? block : spare(static_cast<Index>(active.size()));
    if (!whole) copy_columns(block, active, part);
    const MatXcd combination = append_orthonormal(part);
    const Index count = combination.cols();
    append_rows(coordinates, count);
    if (whole && count == block.cols()) {  // nothing remains
      coordinates.bottomRows(count) = combination.inverse();
      break;
    }
    const TallView<Complex> basis(candidate_.col(candidates_ - count).data(), block.rows(), count);
    coordinates.bottomRows(count) = adjoint_product<Complex>({&basis, 1}, block);
    subtract_product<Complex>({&basis, 1}, coordinates.bottomRows(count), block);
    norms = column_norms(block);
  }
  return coordinates;
}

// Takes the directions of V and C out of a block, once more from columns of which that cancelled
// half. NOTE: leaving that to where it cancels a digit lets the loss of orthogonality multiply from
// step to step, and the recurrence stalls
template <class Scalar>
void BlockKrylov<Scalar>::orthogonalise(Eigen::Ref<MatXcd> block, const VecXd& before,
                                        const VecXd& negligible, MatXcd& coordinates) {
  coordinates += project_out(block);
  const VecXd after = column_norms(block);
  std::vector<Index> cancelled;
  for (Index j = 0; j < block.cols(); ++j)
    if (after[j] < 0.5 * before[j] && after[j] > negligible[j]) cancelled.push_back(j);
  if (cancelled.empty()) return;
  Eigen::Ref<MatXcd> part = spare(static_cast<Index>(cancelled.size()));
  copy_columns(block, cancelled, part);
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
void BlockKrylov<Scalar>::combine(std::span<const Tall<Scalar>> blocks,
                                  Eigen::Ref<MatXcd> sum) const {
  MatXcd y = rhs_.topRows(expanded_);
  triangle_.topRows(expanded_).template triangularView<Eigen::Upper>().solveInPlace(y);
  sum.setZero();
  subtract_product<Scalar>(views<Scalar>(blocks), -y, sum);
}

template class BlockKrylov<Complex>;
template class BlockKrylov<std::complex<float>>;

}  // namespace floe::krylov
