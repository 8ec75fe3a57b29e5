#pragma once

#include "krylov/tall_products.hpp"

#include <floe/krylov/gmres.hpp>

#include <span>
#include <vector>

namespace floe::krylov {

/// The Krylov space of one cycle of block GMRES (S.2)–(S.4). Orthonormal directions are of two
/// sorts: the expanded ones V, to which A M was applied, and the candidates C, to which it was not
/// yet:
///   A M V = [V C] H
/// Each step turns the candidates so that the first ones hold the most of the residuals, and
/// expands these only. Columns are scaled by the caller so that a residual is small enough when its
/// norm is 1.
template <class Scalar>
class BlockKrylov {
 public:
  explicit BlockKrylov(Index rows) : candidate_(rows, 0), spare_(rows, 0) {}

  /// Starts with residuals, or goes on with others, as many as the caller likes: the true ones
  /// after x was corrected, in which there are no rounding errors of the recurrence. Directions in
  /// which they have no more than 0.01 are left out. They are overwritten.
  void replace_residual(Eigen::Ref<MatXcd> residual);

  /// Norm of each column's residual as the recurrence has it.
  VecXd residual_norms() const;

  Index expanded() const { return expanded_; }

  /// Turns the candidates so that the first of them hold the parts of the residuals above 1 that
  /// are at least `threshold` times the largest, at most `limit` of them. Returns how many; none if
  /// the space cannot grow any more.
  Index choose(double threshold, Index limit);

  /// The first candidates, as `choose` turned them.
  auto chosen(Index count) const { return candidate_.leftCols(count); }

  /// Adds the images A M v of the first candidates, which are expanded then; overwrites them.
  void expand(Eigen::Ref<MatXcd> image);

  /// sum = V y that makes the residuals least, N × columns; `blocks` stand for V, expansion by
  /// expansion.
  void combine(std::span<const Tall<Scalar>> blocks, Eigen::Ref<MatXcd> sum) const;
  std::span<const Tall<Scalar>> blocks() const { return expanded_block_; }

 private:
  auto candidates() const { return candidate_.leftCols(candidates_); }
  TallView<Complex> candidates_view() const {
    return {candidate_.data(), candidate_.rows(), candidates_};
  }
  Eigen::Ref<MatXcd> spare(Index columns);
  Eigen::Ref<MatXcd> append_candidates(Index count);
  MatXcd append_orthonormal(const Eigen::Ref<const MatXcd>& block);
  MatXcd absorb(Eigen::Ref<MatXcd> block, const VecXd& negligible);
  void orthogonalise(Eigen::Ref<MatXcd> block, const VecXd& before, const VecXd& negligible,
                     MatXcd& coordinates);
  MatXcd project_out(Eigen::Ref<MatXcd> block) const;
  Index expanded_columns() const { return rotation_.cols() - candidates_; }
  void reduce(const MatXcd& coordinates, Index count);

  std::vector<Tall<Scalar>> expanded_block_;  // V, one matrix a step
  MatXcd candidate_;                          // C and room for more columns
  Index candidates_ = 0;                      // columns of C
  MatXcd spare_;                              // memory that is asked for once, not at every step
  Index expanded_ = 0;                        // columns of V
  MatXcd rotation_;  // unitary, rotation_ · H = [triangle_; 0]; columns as V, C
  MatXcd triangle_;
  MatXcd rhs_;  // rotation_ · coordinates of the first residuals
};

}  // namespace floe::krylov
