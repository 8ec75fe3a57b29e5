#include "plate/shifted_factor.hpp"

#include <floe/numeric/error.hpp>
#include <floe/plate/mindlin.hpp>
#include <floe/plate/static_correction.hpp>

#include <Eigen/Cholesky>

namespace floe::plate {
StaticCorrection::StaticCorrection(const mesh::Q8Mesh& mesh, const PlateRegions& regions,
                                   const DryModes& modes)
    : modes_(modes), loss_factor_(regions.loss_factor()) {
  // NOTE: the shift only makes K + sM definite; a hundredth of the highest mode's ω² keeps the
  // factor well conditioned and the correction small
  const double highest = modes.omega.maxCoeff();
  FLOE_VALIDATE(highest > 0.0, "invalid modes.count = " << modes.count()
                                                        << " (must hold an elastic mode for "
                                                           "section forces)");
  shift_ = 0.01 * highest * highest;
  PlateMatrices plate = assemble_plate(mesh, regions);
  factor_ = std::make_shared<const ShiftedFactor>(plate, shift_);
  mass_ = std::move(plate.mass);
  inertia_ = mass_ * modes.shape;
}

MatXcd StaticCorrection::displacement(const Eigen::Ref<const MatXcd>& load, double omega,
                                      const MatXcd& amplitudes) const {
  FLOE_EXPECT(kUnknownsPerNode * load.rows() == inertia_.rows());
  // Take from the pressure's load what the modes carry: (K - ω²M) C = M C (Λ - ω²)
  VecXcd dynamic = Complex(1.0, -loss_factor_) * modes_.omega.cwiseAbs2().cast<Complex>();
  dynamic.array() -= omega * omega;
  MatXcd rest = -(inertia_.cast<Complex>() * (dynamic.asDiagonal() * amplitudes));
  for (Index node = 0; node < load.rows(); ++node)
    rest.row(kUnknownsPerNode * node) += load.row(node);

  // Make the rest orthogonal to the modes
  const Eigen::LLT<MatXd> gram(modes_.modal_mass);
  const MatXd shape_transposed = modes_.shape.transpose();
  const MatXcd component = shape_transposed.cast<Complex>() * rest;
  const MatXd real = gram.solve(component.real()), imaginary = gram.solve(component.imag());
  rest -= inertia_.cast<Complex>() *
          (real.cast<Complex>() + Complex(0.0, 1.0) * imaginary.cast<Complex>());

  // Solve (K - ω²M) δ = r with K + sM and one correction
  const MatXcd first = factor_->solve(rest);
  rest += (shift_ + omega * omega) * (mass_.cast<Complex>() * first);
  return factor_->solve(rest) / Complex(1.0, -loss_factor_);
}

StaticCorrection::Influence StaticCorrection::influence(const SparseMatrix& functional) const {
  FLOE_EXPECT(functional.cols() == inertia_.rows());
  // Take the modes' share out of a displacement: the transpose of what `displacement` does to loads
  const Eigen::LLT<MatXd> gram(modes_.modal_mass);
  const auto without_modes = [&](MatXd field) -> MatXd {
    return field - modes_.shape * gram.solve(inertia_.transpose() * field);
  };
  MatXd first(functional.cols(), functional.rows()), second(first.rows(), first.cols());
  factor_->solve(MatXd(functional.transpose()), first);
  first = without_modes(std::move(first));
  factor_->solve(mass_ * first, second);
  second = without_modes(std::move(second));
  const auto deflections = Eigen::seq(0, Eigen::last, kUnknownsPerNode);
  return {first(deflections, Eigen::all), second(deflections, Eigen::all), shift_};
}

}  // namespace floe::plate
