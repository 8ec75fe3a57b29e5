#include <algorithm>
#include <floe/numeric/error.hpp>
#include <floe/plate/mindlin.hpp>
#include <floe/plate/section_forces.hpp>
#include <floe/response/modal_basis.hpp>

namespace floe::response {
namespace {

bool is_section_quantity(Quantity quantity) {
  return quantity >= Quantity::kBendingMomentX && quantity <= Quantity::kSurfaceStressY;
}

// Row of the section forces that a quantity needs
int section_row(Quantity quantity) {
  switch (quantity) {
    case Quantity::kBendingMomentX:
    case Quantity::kSurfaceStressX:
      return plate::kBendingMomentX;
    case Quantity::kBendingMomentY:
    case Quantity::kSurfaceStressY:
      return plate::kBendingMomentY;
    case Quantity::kTwistingMoment:
      return plate::kTwistingMoment;
    case Quantity::kShearForceX:
      return plate::kShearForceX;
    default:
      return plate::kShearForceY;
  }
}

// Every `stride`-th row from `first`
MatXd strided_rows(const MatXd& matrix, Index first, Index stride) {
  return matrix(Eigen::seq(first, Eigen::last, stride), Eigen::all);
}

}  // namespace

bool ModalBasis::is_modal(Quantity quantity) {
  return quantity != Quantity::kPressure && quantity != Quantity::kRelativeElevation;
}

ModalBasis::ModalBasis(const mesh::Q8Mesh& mesh, const plate::PlateProperties& properties,
                       const plate::DryModes& modes, const SparseMatrix& interpolation,
                       const std::vector<Quantity>& quantities)
    : loss_factor_(properties.loss_factor) {
  const MatXd deflection = strided_rows(modes.shape, 0, plate::kUnknownsPerNode);
  values_[Quantity::kDeflection] = interpolation * deflection;

  // Recover derivatives at the nodes where they are asked for
  MatXd forces, slope;
  if (std::any_of(quantities.begin(), quantities.end(), is_section_quantity))
    forces = plate::section_forces(mesh, properties, modes.shape);
  const auto wants = [&](Quantity wanted) {
    return std::find(quantities.begin(), quantities.end(), wanted) != quantities.end();
  };
  if (wants(Quantity::kSlopeX) || wants(Quantity::kSlopeY)) slope = plate::slopes(mesh, deflection);

  // NOTE: stress at z = t/2 is M z / I with I = t³/12
  const double stress_factor = 6.0 / (properties.thickness * properties.thickness);
  for (const Quantity quantity : quantities) {
    if (is_section_quantity(quantity)) {
      const bool stress =
          quantity == Quantity::kSurfaceStressX || quantity == Quantity::kSurfaceStressY;
      values_[quantity] = (stress ? stress_factor : 1.0) *
                          (interpolation * strided_rows(forces, section_row(quantity),
                                                        plate::kSectionForces));
    } else if (quantity == Quantity::kSlopeX || quantity == Quantity::kSlopeY) {
      values_[quantity] = interpolation * strided_rows(slope, quantity == Quantity::kSlopeY, 2);
    }
  }
}

MatXcd ModalBasis::evaluate(Quantity quantity, double omega, const MatXcd& amplitudes) const {
  const bool motion = quantity == Quantity::kVelocity || quantity == Quantity::kAcceleration;
  const auto values = values_.find(motion ? Quantity::kDeflection : quantity);
  FLOE_VALIDATE(values != values_.end(),
                "invalid quantity = " << name(quantity) << " (must be one of those asked for)");
  Complex factor = 1.0;
  if (quantity == Quantity::kVelocity) factor = Complex(0.0, -omega);
  if (quantity == Quantity::kAcceleration) factor = -omega * omega;
  if (is_section_quantity(quantity)) factor = Complex(1.0, -loss_factor_);
  return factor * (values->second.cast<Complex>() * amplitudes);
}

}  // namespace floe::response
