#include <plate/recovery.hpp>

#include <cmath>

namespace floe::plate {
namespace {

// The 2 × 2 Gauss points are the corners times this
const double kGaussPoint = 1.0 / std::sqrt(3.0);

}  // namespace

ForceMatrix force_matrix(const ElementPointValues& point, const PlateProperties& properties) {
  ForceMatrix forces;
  forces.topRows<3>() = bending_law(properties) * curvature_matrix(point);
  forces.bottomRows<2>() = shear_law(properties) * shear_matrix(point);
  return forces;
}

GaussForceMatrix gauss_force_matrix(const ElementNodes& nodes, const PlateProperties& properties) {
  const Eigen::Matrix<double, 2, 8>& corner = mesh::q8_parametric_nodes();
  GaussForceMatrix forces;
  for (int g = 0; g < 4; ++g)
    forces.middleRows<kSectionForces>(kSectionForces * g) = force_matrix(
        evaluate_element(nodes, kGaussPoint * corner(0, g), kGaussPoint * corner(1, g)),
        properties);
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
