#pragma once

#include <floe/numeric/types.hpp>

#include <span>
#include <vector>

/// Products of tall matrices: N rows, few columns. Parallel over chunks of rows that do not depend
/// on the number of threads, sums in the order of the chunks: the same bits always. The basis v is
/// stored in `Scalar`, Complex or complex<float>; sums over rows are in double.
namespace floe::krylov {

template <class Scalar>
using Tall = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// N rows side by side in memory, as columns of a larger matrix have them; a view.
template <class Scalar>
using TallView = Eigen::Map<const Tall<Scalar>>;

/// V stands for the blocks side by side.
template <class Scalar>
using Blocks = std::span<const TallView<Scalar>>;

template <class Scalar>
std::vector<TallView<Scalar>> views(std::span<const Tall<Scalar>> blocks) {
  std::vector<TallView<Scalar>> all;
  for (const Tall<Scalar>& block : blocks)
    all.emplace_back(block.data(), block.rows(), block.cols());
  return all;
}

/// V* W
template <class Scalar>
MatXcd adjoint_product(Blocks<Scalar> v, const Eigen::Ref<const MatXcd>& w);

/// W -= V C
template <class Scalar>
void subtract_product(Blocks<Scalar> v, const MatXcd& c, Eigen::Ref<MatXcd> w);

/// W = V C; they must not share memory.
void multiply(const Eigen::Ref<const MatXcd>& v, const MatXcd& c, Eigen::Ref<MatXcd> w);

/// The block in `Scalar`.
template <class Scalar>
Tall<Scalar> stored(const Eigen::Ref<const MatXcd>& block);

/// ‖w_j‖ of each column.
VecXd column_norms(const Eigen::Ref<const MatXcd>& w);

}  // namespace floe::krylov
