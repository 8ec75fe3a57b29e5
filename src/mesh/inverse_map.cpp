#include "mesh/inverse_map.hpp"

#include "mesh/edge_curve.hpp"

#include <floe/mesh/shape_functions.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace floe::mesh {
namespace {

constexpr double kSlack = 1e-8;  // beyond the parametric square, taken as rounding

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

}  // namespace

std::optional<Point2> find_parametric(const ElementNodes& points, const Point2& point) {
  // NOTE: coordinates relative to the point keep their digits far from the origin
  const ElementNodes local = points.colwise() - point;
  const double extent = (local.rowwise().maxCoeff() - local.rowwise().minCoeff()).maxCoeff();
  if (outside_hull(local, Point2::Zero(), kSlack * extent)) return std::nullopt;
  const double accuracy = 1e-12 * extent + 4e-16 * points.cwiseAbs().maxCoeff();

  const auto search = [&](const Point2& start) -> std::optional<Point2> {
    const auto found = newton(local, Point2::Zero(), start, accuracy);
    if (!found || found->cwiseAbs().maxCoeff() > 1.0 + kSlack) return std::nullopt;
    return found->cwiseMax(-1.0).cwiseMin(1.0);
  };
  if (const auto found = search(Point2::Zero())) return found;
  for (const double eta : {-0.75, -0.25, 0.25, 0.75})
    for (const double xi : {-0.75, -0.25, 0.25, 0.75})
      if (const auto found = search({xi, eta})) return found;
  return std::nullopt;
}

}  // namespace floe::mesh
