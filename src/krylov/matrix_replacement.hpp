#pragma once

#include <floe/krylov/linear_operator.hpp>

#include <Eigen/SparseCore>

namespace floe::krylov {

class MatrixReplacement;

}  // namespace floe::krylov

namespace Eigen::internal {

template <>
struct traits<floe::krylov::MatrixReplacement>
    : public traits<Eigen::SparseMatrix<std::complex<double>>> {};

}  // namespace Eigen::internal

namespace floe::krylov {

/// A linear operator in the clothes of a sparse matrix, as Eigen's iterative solvers want it.
class MatrixReplacement : public Eigen::EigenBase<MatrixReplacement> {
 public:
  using Scalar = Complex;
  using RealScalar = double;
  using StorageIndex = int;
  enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic };
  enum { IsRowMajor = 0 };

  /// Keeps a view of the operator.
  explicit MatrixReplacement(const LinearOperator& action) : action_(&action) {}

  Index rows() const { return action_->size(); }
  Index cols() const { return action_->size(); }
  const LinearOperator& action() const { return *action_; }

  template <class Rhs>
  Eigen::Product<MatrixReplacement, Rhs, Eigen::AliasFreeProduct> operator*(
      const Eigen::MatrixBase<Rhs>& x) const {
    return {*this, x.derived()};
  }

 private:
  const LinearOperator* action_;  // view
};

}  // namespace floe::krylov

namespace Eigen::internal {

template <class Rhs>
struct generic_product_impl<floe::krylov::MatrixReplacement, Rhs, SparseShape, DenseShape,
                            GemvProduct>
    : generic_product_impl_base<floe::krylov::MatrixReplacement, Rhs,
                                generic_product_impl<floe::krylov::MatrixReplacement, Rhs>> {
  template <class Dest>
  static void scaleAndAddTo(Dest& y, const floe::krylov::MatrixReplacement& matrix, const Rhs& x,
                            const std::complex<double>& alpha) {
    const Eigen::MatrixXcd in = x;
    Eigen::MatrixXcd out(in.rows(), in.cols());
    matrix.action().apply(in, out);
    y.noalias() += alpha * out;
  }
};

}  // namespace Eigen::internal
