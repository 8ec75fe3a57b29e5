#include "plate/lanczos.hpp"

#include "plate/sparse_products.hpp"

#include <floe/numeric/error.hpp>

#include <Spectra/SymGEigsShiftSolver.h>

#include <algorithm>
#include <random>
#include <stdexcept>

namespace floe::plate {
namespace {

// x → M x, as Spectra asks for it
class MassProduct final {
 public:
  using Scalar = double;
  explicit MassProduct(const NodeMass& mass) : mass_(mass) {}
  Index rows() const { return mass_.size(); }
  Index cols() const { return mass_.size(); }
  void perform_op(const double* x, double* y) const { mass_.apply(x, y); }

 private:
  const NodeMass& mass_;  // view
};

// x → (1 - Z Zᵀ M)(K + sM)⁻¹ x
class DeflatedInverse final {
 public:
  using Scalar = double;
  DeflatedInverse(const ShiftedFactor& factor, const NodeMass& mass,
                  const Eigen::Ref<const MatXd>& deflated)
      : factor_(factor), mass_(mass), deflated_(deflated) {}
  Index rows() const { return factor_.size(); }
  Index cols() const { return factor_.size(); }
  void set_shift(const double&) {}
  void perform_op(const double* x, double* y) const {
    Eigen::Map<VecXd> solution(y, rows());
    factor_.solve(Eigen::Map<const VecXd>(x, rows()), solution);
    deflate(solution);
  }
  void deflate(Eigen::Ref<VecXd> x) const {
    if (deflated_.cols() == 0) return;
    subtract_combination(deflated_, inner_products(deflated_, mass_ * x), x);
  }

 private:
  const ShiftedFactor& factor_;              // view
  const NodeMass& mass_;                     // view
  const Eigen::Ref<const MatXd>& deflated_;  // view
};

// NOTE: the start is random, so that no symmetry of the plate hides a mode; and the same on every
// machine, for which the generator's bits are used as they are.
VecXd start_vector(const DeflatedInverse& inverse, const NodeMass& mass, unsigned seed) {
  std::mt19937_64 generator(seed);
  VecXd random(mass.size());
  for (double& value : random) value = static_cast<double>(generator() >> 11) * 0x1p-53 - 0.5;
  const VecXd load = mass * random;
  VecXd start(mass.size());
  inverse.perform_op(load.data(), start.data());
  return start;
}

}  // namespace

Eigenpairs lowest_eigenpairs(const NodeMass& node_mass, const ShiftedFactor& factor, double shift,
                             const Eigen::Ref<const MatXd>& deflated,
                             const LanczosOptions& options) {
  const Index dimension = factor.size() - deflated.cols();
  const Index space = std::min(dimension, std::max(2 * options.count, options.count + 20));
  MassProduct mass(node_mass);
  DeflatedInverse inverse(factor, node_mass, deflated);
  Spectra::SymGEigsShiftSolver<DeflatedInverse, MassProduct, Spectra::GEigsMode::ShiftInvert>
      solver(inverse, mass, options.count, space, -shift);
  try {
    solver.init(start_vector(inverse, node_mass, options.seed).data());
    solver.compute(Spectra::SortRule::LargestMagn, options.max_restarts, options.tolerance,
                   Spectra::SortRule::SmallestAlge);
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& error) {
    FLOE_DETAIL_THROW(ConvergenceError, "dry modes failed: " << error.what());
  }
  return {solver.eigenvalues(), solver.eigenvectors(), solver.num_operations() + 1};
}

}  // namespace floe::plate
