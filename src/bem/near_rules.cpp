#include "bem/near_rules.hpp"

#include <floe/numeric/gauss_legendre.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace floe::bem {
namespace {

constexpr int kDeepestHalving = 60;

double distance_to_segment(const Point2& p, const Point2& a, const Point2& b) {
  const Point2 ab = b - a;
  const double t = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
  return (p - a - t * ab).norm();
}

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

// A rectangle in the parametric plane
struct Cell {
  Point2 centre, half;
};

ElementNodes cell_nodes(const ElementNodes& nodes, const Cell& cell) {
  ElementNodes sub;
  for (int a = 0; a < 8; ++a) {
    const Point2 at = cell.centre + cell.half.cwiseProduct(mesh::q8_parametric_nodes().col(a));
    sub.col(a) = nodes * mesh::q8_shape(at.x(), at.y());
  }
  return sub;
}

void add_cell(const Point2& target, const ElementNodes& nodes, const Cell& cell, double wavenumber,
              const FarRules& rules, int depth, QuadraturePoints& points) {
  // Take the cell as it is if an order is high enough for its distance
  const ElementNodes corner = cell_nodes(nodes, cell);
  const double along_xi = (corner.col(5) - corner.col(7)).norm();
  const double along_eta = (corner.col(6) - corner.col(4)).norm();
  const double half_edge = 0.5 * std::max(along_xi, along_eta);
  const int tier = std::max(rules.tier_for_gap(distance_to_element(target, corner), half_edge),
                            rules.tier_for_wave(wavenumber, half_edge));
  if (tier < FarRules::kTooNear || depth == kDeepestHalving) {
    const int order = FarRules::kOrders[std::min(tier, FarRules::kTiers - 1)];
    const auto& gauss = numeric::gauss_legendre(order);
    const double scale = cell.half.x() * cell.half.y();
    for (int i = 0; i < order; ++i)
      for (int j = 0; j < order; ++j)
        points.add(cell.centre.x() + cell.half.x() * gauss.node[i],
                   cell.centre.y() + cell.half.y() * gauss.node[j],
                   scale * gauss.weight[i] * gauss.weight[j]);
    return;
  }

  // Halve it across its longer direction
  const int axis = along_xi >= along_eta ? 0 : 1;
  for (const double side : {-0.5, 0.5}) {
    Cell child = cell;
    child.half[axis] *= 0.5;
    child.centre[axis] += side * cell.half[axis];
    add_cell(target, nodes, child, wavenumber, rules, depth + 1, points);
  }
}

// Radial panels of [0, 1] for an edge point at distance `length` from the apex: the first ends at
// the smallest scale of G, each next one is twice as long
std::vector<double> radial_breaks(double length, double scale) {
  std::vector<double> breaks{0.0};
  for (double r = scale; r < 0.75 * length; r *= 2.0) breaks.push_back(r / length);
  breaks.push_back(1.0);
  return breaks;
}

struct Triangle {
  Point2 apex, first, second;  // parametric; the edge runs from apex + first to apex + second
};

void add_ray(const Triangle& triangle, double s, double edge_weight, double length, double scale,
             int order, QuadraturePoints& points) {
  const auto& gauss = numeric::gauss_legendre(order);
  const Point2 edge = triangle.first + s * (triangle.second - triangle.first);
  const std::vector<double> breaks = radial_breaks(length, scale);
  for (std::size_t panel = 0; panel + 1 < breaks.size(); ++panel)
    for (int i = 0; i < order; ++i) {
      const double half = 0.5 * (breaks[panel + 1] - breaks[panel]);
      double t = breaks[panel] + half * (1.0 + gauss.node[i]);
      double dt = half * gauss.weight[i];
      if (panel == 0) {
        // t = τ³ on the panel that touches the apex
        const double tau = 0.5 * (1.0 + gauss.node[i]);
        t = breaks[1] * tau * tau * tau;
        dt = breaks[1] * 3.0 * tau * tau * 0.5 * gauss.weight[i];
      }
      const Point2 at = triangle.apex + t * edge;
      points.add(at.x(), at.y(), edge_weight * t * dt);
    }
}

void add_triangle(const ElementNodes& nodes, const Triangle& triangle, double scale, int order,
                  QuadraturePoints& points) {
  const double twice_area = cross(triangle.first, triangle.second);
  if (twice_area <= 1e-12) return;

  // Write the squared length of the edge point, as the apex' Jacobian maps it, as a²((s-s0)² + b²)
  const Eigen::Matrix2d jacobian =
      nodes * mesh::q8_shape_gradient(triangle.apex.x(), triangle.apex.y()).transpose();
  const Point2 first = jacobian * triangle.first;
  const Point2 along = jacobian * (triangle.second - triangle.first);
  const double a = along.norm();
  const double s0 = -first.dot(along) / (a * a);
  const double b = std::abs(cross(first, along)) / (a * a);

  // s = s0 + b sinh u turns ds / length into du / a
  const double from = std::asinh(-s0 / b), to = std::asinh((1.0 - s0) / b);
  const auto& gauss = numeric::gauss_legendre(order);
  const int panels = 1 + static_cast<int>((to - from) / 3.0);
  for (int panel = 0; panel < panels; ++panel)
    for (int i = 0; i < order; ++i) {
      const double half = 0.5 * (to - from) / panels;
      const double u = from + half * (2.0 * panel + 1.0 + gauss.node[i]);
      const double s = s0 + b * std::sinh(u);
      const double weight = half * gauss.weight[i] * b * std::cosh(u) * twice_area;
      add_ray(triangle, s, weight, a * b * std::cosh(u), scale, order, points);
    }
}

}  // namespace

double distance_to_element(const Point2& point, const ElementNodes& nodes) {
  static constexpr int kRing[9] = {0, 4, 1, 5, 2, 6, 3, 7, 0};
  double distance = std::numeric_limits<double>::infinity();
  bool inside = true;
  for (int i = 0; i < 8; ++i) {
    const Point2 a = nodes.col(kRing[i]), b = nodes.col(kRing[i + 1]);
    distance = std::min(distance, distance_to_segment(point, a, b));
    inside = inside && cross(b - a, point - a) >= 0.0;
  }
  return inside ? 0.0 : distance;
}

void add_near_points(const Point2& target, const ElementNodes& nodes, double wavenumber,
                     const FarRules& rules, QuadraturePoints& points) {
  add_cell(target, nodes, {Point2(0.0, 0.0), Point2(1.0, 1.0)}, wavenumber, rules, 0, points);
}

void add_singular_points(const ElementNodes& nodes, double xi, double eta, double smallest_scale,
                         int order, QuadraturePoints& points) {
  const Point2 apex(xi, eta);
  for (int side = 0; side < 4; ++side) {
    const Point2 first = mesh::q8_parametric_nodes().col(side) - apex;
    const Point2 second = mesh::q8_parametric_nodes().col((side + 1) % 4) - apex;
    add_triangle(nodes, {apex, first, second}, smallest_scale, order, points);
  }
}

}  // namespace floe::bem
