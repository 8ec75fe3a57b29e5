#pragma once

#include "krylov/tall_products.hpp"

#include <floe/krylov/gmres.hpp>

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
  /// Starts with the residuals. Directions in which they have no more than 0.01 are left out.
  explicit BlockKrylov(MatXcd residual);

  /// Goes on with other residuals, and as many as the caller likes: the true ones after x was
  /// corrected, in which there are no rounding errors of the recurrence.
  void replace_residual(MatXcd residual);

  /// Norm of each column's residual as the recurrence has it.
  VecXd residual_norms() const;

  Index expanded() const { return expanded_; }
  Index candidates() const { return candidate_.cols(); }

  /// Turns the candidates so that the first of them hold the parts of the residuals above 1 that
  /// are at least `threshold` times the largest, at most `limit` of them. Returns these; there are
  /// none if the space cannot grow any more.
  MatXcd choose(double threshold, Index limit);

  /// Adds the images A M v of the directions that `choose` returned; they are overwritten.
  void expand(const MatXcd& chosen, MatXcd image);

  /// V y that makes the residuals least, N × columns; `blocks` stand for V, expansion by expansion.
  MatXcd combine(Blocks<Scalar> blocks) const;
  Blocks<Scalar> blocks() const { return expanded_block_; }

 private:
  MatXcd absorb(MatXcd& block, const VecXd& negligible);
  void orthogonalise(MatXcd& block, const VecXd& before, const VecXd& negligible,
                     MatXcd& coordinates) const;
  MatXcd project_out(MatXcd& block) const;
  void append_candidates(const MatXcd& direction);
  Index expanded_columns() const { return rotation_.cols() - candidate_.cols(); }
  void reduce(const MatXcd& coordinates, Index count);

  std::vector<Tall<Scalar>> expanded_block_;  // V, one matrix a step
  MatXcd candidate_;                          // C
  Index expanded_ = 0;                        // columns of V
  MatXcd rotation_;  // unitary, rotation_ · H = [triangle_; 0]; columns as V, C
  MatXcd triangle_;
  MatXcd rhs_;  // rotation_ · coordinates of the first residuals
};

}  // namespace floe::krylov
