#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <array>

namespace floe::mesh {

/// Lengths below this share of the mesh's size count as zero.
inline constexpr double kRelativeTolerance = 1e-6;

/// Coordinates of an element's eight nodes, one a column [m].
using ElementNodes = Eigen::Matrix<double, 2, 8>;

inline ElementNodes gather_nodes(const Points2& nodes, const Connectivity& elements,
                                 Index element) {
  ElementNodes points;
  for (int a = 0; a < 8; ++a) points.col(a) = nodes.col(elements(a, element));
  return points;
}

/// det J = ∂(x, y)/∂(ξ, η) at the 3 × 3 Gauss points [m²].
std::array<double, 9> gauss_point_jacobians(const ElementNodes& points);

/// ∫ det J dξ dη by the 3 × 3 rule, exact for a Q8 element [m²]; negative if it runs clockwise.
double signed_area(const ElementNodes& points);

inline double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace floe::mesh
