#include "plate/recovery.hpp"

#include <cmath>

namespace floe::plate {
namespace {

// The 2 × 2 Gauss points are the corners times this
const double kGaussPoint = 1.0 / std::sqrt(3.0);

}  // namespace

GaussForceMatrix gauss_force_matrix(const ElementNodes& nodes, const PlateProperties& properties) {
  const Eigen::Matrix<double, 2, 8>& corner = mesh::q8_parametric_nodes();
  const AssumedShear strain(nodes);
  GaussForceMatrix forces;
  for (int g = 0; g < 4; ++g) {
    const double xi = kGaussPoint * corner(0, g), eta = kGaussPoint * corner(1, g);
    forces.middleRows<3>(kSectionForces * g) =
        bending_law(properties) * curvature_matrix(evaluate_element(nodes, xi, eta));
    forces.middleRows<2>(kSectionForces * g + kShearForceX) =
        shear_law(properties) * strain.at(xi, eta);
  }
  return forces;
}

Eigen::Vector4d extrapolation_weights(double xi, double eta) {
  const Eigen::Matrix<double, 2, 8>& corner = mesh::q8_parametric_nodes();
  Eigen::Vector4d weight;
  for (int g = 0; g < 4; ++g)
    weight[g] =
        0.25 * (1.0 + corner(0, g) * xi / kGaussPoint) * (1.0 + corner(1, g) * eta / kGaussPoint);
  return weight;
}

NodalForceMatrix nodal_force_matrix(const ElementNodes& nodes, const PlateProperties& properties) {
  const Eigen::Matrix<double, 2, 8>& place = mesh::q8_parametric_nodes();
  const GaussForceMatrix gauss = gauss_force_matrix(nodes, properties);
  NodalForceMatrix forces = NodalForceMatrix::Zero();
  for (int a = 0; a < 8; ++a) {
    const Eigen::Vector4d weight = extrapolation_weights(place(0, a), place(1, a));
    for (int g = 0; g < 4; ++g)
      forces.middleRows<kSectionForces>(kSectionForces * a) +=
          weight[g] * gauss.middleRows<kSectionForces>(kSectionForces * g);
  }
  return forces;
}

NodalSlopeMatrix nodal_slope_matrix(const ElementNodes& nodes) {
  const Eigen::Matrix<double, 2, 8>& place = mesh::q8_parametric_nodes();
  // NOTE: the gradient at the nodes themselves. Extrapolated from the Gauss points, where a Q8
  // gradient is most accurate, its error is the same for the shapes of long waves and up to a fifth
  // larger for short ones (measured on dry modes against a mesh three to twelve times finer).
  NodalSlopeMatrix slope;
  for (int a = 0; a < 8; ++a)
    slope.middleRows<2>(2 * a) = evaluate_element(nodes, place(0, a), place(1, a)).gradient;
  return slope;
}

}  // namespace floe::plate
