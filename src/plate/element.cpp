#include "plate/element.hpp"

#include <floe/numeric/gauss_legendre.hpp>

#include <Eigen/LU>

namespace floe::plate {

ElementPointValues evaluate_element(const ElementNodes& nodes, double xi, double eta) {
  const mesh::ShapeGradient8 parametric = mesh::q8_shape_gradient(xi, eta);
  const Eigen::Matrix2d jacobian = parametric * nodes.transpose();
  return {mesh::q8_shape(xi, eta), jacobian.inverse() * parametric, jacobian.determinant()};
}

CurvatureMatrix curvature_matrix(const ElementPointValues& point) {
  CurvatureMatrix b = CurvatureMatrix::Zero();
  for (int a = 0; a < 8; ++a) {
    const double dx = point.gradient(0, a), dy = point.gradient(1, a);
    b(0, 3 * a + 2) = dx;
    b(1, 3 * a + 1) = -dy;
    b(2, 3 * a + 2) = dy;
    b(2, 3 * a + 1) = -dx;
  }
  return b;
}

Eigen::Matrix3d bending_law(const PlateProperties& properties) {
  const double nu = properties.poisson_ratio;
  Eigen::Matrix3d law;
  law << 1.0, nu, 0.0, nu, 1.0, 0.0, 0.0, 0.0, 0.5 * (1.0 - nu);
  return properties.bending_rigidity() * law;
}

double shear_law(const PlateProperties& properties) {
  return properties.shear_correction * properties.shear_modulus() * properties.thickness;
}

ElementMatrix element_stiffness(const ElementNodes& nodes, const PlateProperties& properties) {
  ElementMatrix stiffness = ElementMatrix::Zero();

  // Add bending
  const Eigen::Matrix3d bending = bending_law(properties);
  const numeric::QuadratureRule& three = numeric::gauss_legendre(3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const ElementPointValues point = evaluate_element(nodes, three.node[i], three.node[j]);
      const CurvatureMatrix b = curvature_matrix(point);
      const double weight = three.weight[i] * three.weight[j] * point.jacobian;
      const CurvatureMatrix moments = (weight * bending) * b;
      stiffness.noalias() += b.transpose().lazyProduct(moments);
    }

  // Add shear
  const AssumedShear strain(nodes);
  const double shear = shear_law(properties);
  const numeric::QuadratureRule& two = numeric::gauss_legendre(2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const ElementPointValues point = evaluate_element(nodes, two.node[i], two.node[j]);
      const ShearMatrix b = strain.at(two.node[i], two.node[j]);
      const double weight = two.weight[i] * two.weight[j] * point.jacobian * shear;
      stiffness.noalias() += weight * b.transpose().lazyProduct(b);
    }
  stiffness.triangularView<Eigen::StrictlyUpper>() = stiffness.transpose();
  return stiffness;
}

Eigen::Matrix<double, 8, 8> element_shape_products(const ElementNodes& nodes) {
  Eigen::Matrix<double, 8, 8> products = Eigen::Matrix<double, 8, 8>::Zero();
  const numeric::QuadratureRule& three = numeric::gauss_legendre(3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const ElementPointValues point = evaluate_element(nodes, three.node[i], three.node[j]);
      const double weight = three.weight[i] * three.weight[j] * point.jacobian;
      for (int b = 0; b < 8; ++b)
        for (int a = 0; a < 8; ++a) products(a, b) += weight * (point.shape[a] * point.shape[b]);
    }
  return products;
}

}  // namespace floe::plate
