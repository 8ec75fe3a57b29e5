#pragma once

#include <floe/numeric/types.hpp>

#include <cstdint>
#include <vector>

/// Products that give the same bits for any number of threads.
namespace floe::plate {

/// A X of a symmetric A with both triangles stored.
MatXd multiply_symmetric(const SparseMatrix& matrix, const Eigen::Ref<const MatXd>& x);

/// The mass matrix as what it is, ∫N_a N_b m dS for w, θx and θy alike but for a factor each: a
/// third of the entries, and half of their bytes. The Lanczos iteration spends a third of its time
/// in it. A matrix that is none such (a plate of several thicknesses, or one from elsewhere) is
/// kept as it is, in place of it.
class NodeMass final {
 public:
  explicit NodeMass(const SparseMatrix& mass);
  Index size() const {
    return general_.size() > 0 ? general_.cols() : 3 * (static_cast<Index>(begin_.size()) - 1);
  }
  void apply(const double* x, double* y) const;  ///< y = M x
  MatXd operator*(const Eigen::Ref<const MatXd>& x) const;

 private:
  std::vector<Index> begin_;
  std::vector<std::int32_t> node_;
  std::vector<double> value_;  ///< of w
  double rotary_ = 0.0;        ///< factor of θx and θy
  SparseMatrix general_;       ///< the matrix itself; empty where the above says it all
};

/// XᵀY, summed in blocks of rows of a fixed size.
MatXd inner_products(const Eigen::Ref<const MatXd>& x, const Eigen::Ref<const MatXd>& y);

/// Y - X c, in place.
void subtract_combination(const Eigen::Ref<const MatXd>& x, const Eigen::Ref<const MatXd>& c,
                          Eigen::Ref<MatXd> y);

/// X c in place of X; c is square.
void combine_columns(const Eigen::Ref<const MatXd>& c, Eigen::Ref<MatXd> x);

}  // namespace floe::plate
