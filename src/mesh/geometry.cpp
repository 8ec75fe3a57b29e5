#include "mesh/geometry.hpp"

#include <floe/mesh/shape_functions.hpp>
#include <floe/numeric/gauss_legendre.hpp>

namespace floe::mesh {
namespace {

// Shape function gradients and weights at the 3 × 3 Gauss points
struct GaussPoints {
  std::array<ShapeGradient8, 9> gradient;
  std::array<double, 9> weight;
};

const GaussPoints& gauss_points() {
  static const GaussPoints points = [] {
    const auto& rule = numeric::gauss_legendre(3);
    GaussPoints made;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        made.gradient[3 * i + j] = q8_shape_gradient(rule.node[i], rule.node[j]);
        made.weight[3 * i + j] = rule.weight[i] * rule.weight[j];
      }
    return made;
  }();
  return points;
}

}  // namespace

std::array<double, 9> gauss_point_jacobians(const ElementNodes& points) {
  // NOTE: nodes relative to the first one, so that a mesh far from the origin keeps its digits
  const ElementNodes local = points.colwise() - points.col(0).eval();
  std::array<double, 9> determinant;
  for (int g = 0; g < 9; ++g) {
    const Eigen::Matrix2d jacobian = gauss_points().gradient[g] * local.transpose();
    determinant[g] = jacobian(0, 0) * jacobian(1, 1) - jacobian(0, 1) * jacobian(1, 0);
  }
  return determinant;
}

double signed_area(const ElementNodes& points) {
  const std::array<double, 9> determinant = gauss_point_jacobians(points);
  double area = 0.0;
  for (int g = 0; g < 9; ++g) area += gauss_points().weight[g] * determinant[g];
  return area;
}

}  // namespace floe::mesh
