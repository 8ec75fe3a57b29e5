#pragma once

#include <floe/numeric/types.hpp>

#include <span>

/// Products of tall matrices: N rows, few columns. Parallel over chunks of rows that do not depend
/// on the number of threads, sums in the order of the chunks: the same bits always. The basis v is
/// stored in `Scalar`, Complex or complex<float>; sums over rows are in double.
namespace floe::krylov {

template <class Scalar>
using Tall = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// V stands for the blocks side by side.
template <class Scalar>
using Blocks = std::span<const Tall<Scalar>>;

/// V* W
template <class Scalar>
MatXcd adjoint_product(Blocks<Scalar> v, const Eigen::Ref<const MatXcd>& w);

/// W -= V C
template <class Scalar>
void subtract_product(Blocks<Scalar> v, const MatXcd& c, Eigen::Ref<MatXcd> w);

/// V C
MatXcd product(const Eigen::Ref<const MatXcd>& v, const MatXcd& c);

/// ‖w_j‖ of each column.
VecXd column_norms(const Eigen::Ref<const MatXcd>& w);

}  // namespace floe::krylov
