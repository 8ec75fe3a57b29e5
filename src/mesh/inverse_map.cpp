#include "mesh/inverse_map.hpp"

#include "mesh/edge_curve.hpp"

#include <floe/mesh/shape_functions.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace floe::mesh {
namespace {

constexpr double kSlack = 1e-8;               // beyond the parametric square, taken as rounding
constexpr double kSmallestPart = 1.0 / 32.0;  // half width of the squares that Newton starts from

// True if a line along the chord of an edge leaves the point on one side and the element, which
// lies within the hull of its edges' control points, on the other
bool outside_hull(const ElementNodes& points, const Point2& point, double margin) {
  std::array<EdgeCurve, 4> edges;
  for (int side = 0; side < 4; ++side) edges[side] = edge_curve(points, side);
  for (const EdgeCurve& edge : edges) {
    const Point2 chord = edge.end - edge.start;
    double low = 0.0, high = 0.0;
    for (const EdgeCurve& other : edges)
      for (const Point2& corner : {other.start, other.control}) {
        low = std::min(low, cross(chord, corner - edge.start));
        high = std::max(high, cross(chord, corner - edge.start));
      }
    const double place = cross(chord, point - edge.start);
    const double width = margin * chord.norm();
    if (place < low - width || place > high + width) return true;
  }
  return false;
}

// Newton from `parametric`; nothing if it does not converge
std::optional<Point2> newton(const ElementNodes& points, const Point2& point, Point2 parametric,
                             double accuracy) {
  const auto residual_at = [&](const Point2& place) -> Point2 {
    return points * q8_shape(place.x(), place.y()) - point;
  };
  Point2 residual = residual_at(parametric);
  for (int iteration = 0; iteration < 40; ++iteration) {
    const Eigen::Matrix2d jacobian =
        points * q8_shape_gradient(parametric.x(), parametric.y()).transpose();
    Point2 step = -jacobian.inverse() * residual;
    if (!step.allFinite()) return std::nullopt;

    // Halve the step until it stays near the square and the residual falls
    bool fell = false;
    for (int halving = 0; halving < 12 && !fell; ++halving, step *= 0.5) {
      const Point2 next = parametric + step;
      if (next.cwiseAbs().maxCoeff() > 2.0) continue;
      const Point2 next_residual = residual_at(next);
      if (!(next_residual.norm() < residual.norm())) continue;
      parametric = next;
      residual = next_residual;
      fell = true;
    }
    if (!fell) break;
  }
  if (residual.norm() > accuracy) return std::nullopt;
  return parametric;
}

// Box around the part of an element over a square of the parametric plane. The part is a Q8 element
// too; the box holds the 3 × 3 control points of its Bernstein form, and so the part itself.
Box part_box(const ElementNodes& points, const Point2& centre, double half_width, double margin) {
  ElementNodes part;
  for (int a = 0; a < 8; ++a) {
    const Point2 place = centre + half_width * q8_parametric_nodes().col(a);
    part.col(a) = points * q8_shape(place.x(), place.y());
  }
  Box box = element_box(part);
  const Point2 corners = part.leftCols<4>().rowwise().sum();
  const Point2 middles = part.rightCols<4>().rowwise().sum();
  const Point2 middle_control = middles - 0.75 * corners;  // from x(0, 0) = middles/2 - corners/4
  box.lower = box.lower.cwiseMin(middle_control).array() - margin;
  box.upper = box.upper.cwiseMax(middle_control).array() + margin;
  return box;
}

}  // namespace

std::optional<Point2> find_parametric(const ElementNodes& points, const Point2& point) {
  // NOTE: coordinates relative to the point keep their digits far from the origin
  const ElementNodes local = points.colwise() - point;
  const double extent = (local.rowwise().maxCoeff() - local.rowwise().minCoeff()).maxCoeff();
  const double margin = kSlack * extent;
  if (outside_hull(local, Point2::Zero(), margin)) return std::nullopt;
  const double accuracy = 1e-12 * extent + 4e-16 * points.cwiseAbs().maxCoeff();
  const auto search = [&](const Point2& start) -> std::optional<Point2> {
    const auto found = newton(local, Point2::Zero(), start, accuracy);
    if (!found || found->cwiseAbs().maxCoeff() > 1.0 + kSlack) return std::nullopt;
    return found->cwiseMax(-1.0).cwiseMin(1.0);
  };
  if (auto found = search(Point2::Zero())) return found;

  // Quarter the parametric square, and again, where the point can be; start from the small squares
  const auto search_part = [&](const auto& self, const Point2& centre,
                               double half_width) -> std::optional<Point2> {
    const Box box = part_box(local, centre, half_width, margin);
    if (!box.touches(box_around(Point2::Zero(), 0.0))) return std::nullopt;
    if (half_width <= kSmallestPart) return search(centre);
    for (const double y : {-0.5, 0.5})
      for (const double x : {-0.5, 0.5})
        if (auto found = self(self, centre + half_width * Point2(x, y), 0.5 * half_width))
          return found;
    return std::nullopt;
  };
  return search_part(search_part, Point2::Zero(), 1.0);
}

}  // namespace floe::mesh
