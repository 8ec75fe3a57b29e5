#include "mesh/geometry.hpp"
#include "mesh/half_edges.hpp"

#include <floe/mesh/mesh_quality.hpp>
#include <floe/mesh/shape_functions.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace floe::mesh {
namespace {

double edge_length(const ElementNodes& points, int side) {
  const Point2 start = points.col(side), middle = points.col(4 + side);
  const Point2 end = points.col((side + 1) % 4);
  return (middle - start).norm() + (end - middle).norm();
}

// Ratio of the singular values of J at the centre: with s = |J|² / 2 and d = det J they are
// σ² = s ± √(s² - d²), so that σ₁/σ₂ = (s + √(s² - d²)) / d
double aspect_ratio(const ElementNodes& points) {
  const Eigen::Matrix2d jacobian = q8_shape_gradient(0.0, 0.0) * points.transpose();
  const double half_square = 0.5 * jacobian.squaredNorm();
  const double determinant =
      std::abs(jacobian(0, 0) * jacobian(1, 1) - jacobian(0, 1) * jacobian(1, 0));
  const double root =
      std::sqrt(std::max(0.0, half_square * half_square - determinant * determinant));
  return (half_square + root) / determinant;
}

void measure_edges(const Q8Mesh& mesh, MeshQuality& quality) {
  quality.shortest_edge = std::numeric_limits<double>::infinity();
  for (Index e = 0; e < mesh.element_count(); ++e)
    for (int side = 0; side < 4; ++side) {
      const double length = edge_length(mesh.element_nodes(e), side);
      if (length < quality.shortest_edge) {
        quality.shortest_edge = length;
        quality.shortest_edge_element = e;
      }
      if (length > quality.longest_edge) {
        quality.longest_edge = length;
        quality.longest_edge_element = e;
      }
    }
}

void measure_shapes(const Q8Mesh& mesh, MeshQuality& quality) {
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const ElementNodes points = mesh.element_nodes(e);
    const double aspect = aspect_ratio(points);
    if (aspect > quality.worst_aspect_ratio) {
      quality.worst_aspect_ratio = aspect;
      quality.worst_aspect_element = e;
    }
    const auto determinants = gauss_point_jacobians(points);
    const auto [smallest, largest] = std::minmax_element(determinants.begin(), determinants.end());
    if (*smallest / *largest < quality.worst_jacobian_ratio) {
      quality.worst_jacobian_ratio = *smallest / *largest;
      quality.worst_jacobian_element = e;
    }
  }
}

void measure_jumps(const Q8Mesh& mesh, MeshQuality& quality) {
  const std::vector<HalfEdge> half_edges = sorted_half_edges(mesh.elements());
  for_each_edge(half_edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() < 2) return;
    // The length of the edge cancels in the ratio of the depths
    const double first = signed_area(mesh.element_nodes(edge[0].element));
    const double second = signed_area(mesh.element_nodes(edge[1].element));
    const double jump = std::max(first, second) / std::min(first, second);
    const bool is_first = quality.edge_jump_element == quality.edge_jump_neighbour;
    if (jump <= quality.largest_edge_jump && !is_first) return;
    quality.largest_edge_jump = jump;
    quality.edge_jump_element = edge[first >= second ? 0 : 1].element;
    quality.edge_jump_neighbour = edge[first >= second ? 1 : 0].element;
  });
}

}  // namespace

VecXd longest_edges(const Q8Mesh& mesh) {
  VecXd longest = VecXd::Zero(mesh.element_count());
  for (Index e = 0; e < mesh.element_count(); ++e)
    for (int side = 0; side < 4; ++side)
      longest[e] = std::max(longest[e], edge_length(mesh.element_nodes(e), side));
  return longest;
}

MeshQuality measure_quality(const Q8Mesh& mesh) {
  MeshQuality quality;
  measure_edges(mesh, quality);
  measure_shapes(mesh, quality);
  measure_jumps(mesh, quality);
  return quality;
}

}  // namespace floe::mesh
