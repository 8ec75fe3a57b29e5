#include "mesh/edge_curve.hpp"

#include <array>
#include <cmath>

namespace floe::mesh {
namespace {

using ControlPoints = std::array<Point2, 3>;

ControlPoints control_points(const EdgeCurve& curve) {
  return {curve.start, curve.control, curve.end};
}

// Distance of the curve from its chord, at most
double bulge(const EdgeCurve& curve) {
  return 0.25 * (curve.start - 2.0 * curve.control + curve.end).norm();
}

// True if a line along the chord of `a` lies between the control points of the two curves
bool chord_separates(const EdgeCurve& a, const EdgeCurve& b) {
  const Point2 chord = a.end - a.start;
  double low_a = INFINITY, high_a = -INFINITY, low_b = INFINITY, high_b = -INFINITY;
  for (const Point2& point : control_points(a)) {
    low_a = std::min(low_a, cross(chord, point - a.start));
    high_a = std::max(high_a, cross(chord, point - a.start));
  }
  for (const Point2& point : control_points(b)) {
    low_b = std::min(low_b, cross(chord, point - a.start));
    high_b = std::max(high_b, cross(chord, point - a.start));
  }
  return high_a < low_b || high_b < low_a;
}

bool segments_meet(const EdgeCurve& a, const EdgeCurve& b) {
  const auto straddles = [](const EdgeCurve& line, const EdgeCurve& other) {
    const Point2 chord = line.end - line.start;
    const double from = cross(chord, other.start - line.start);
    const double to = cross(chord, other.end - line.start);
    return (from <= 0.0 && to >= 0.0) || (from >= 0.0 && to <= 0.0);
  };
  return straddles(a, b) && straddles(b, a);
}

bool split_curves_meet(const EdgeCurve& a, const EdgeCurve& b, double flatness, int depth) {
  constexpr int kDeepest = 24;  // each curve bulges 4^12 times less by then
  if (!a.box(0.0).touches(b.box(0.0))) return false;
  if (chord_separates(a, b) || chord_separates(b, a)) return false;
  const double bulge_a = bulge(a), bulge_b = bulge(b);
  if (std::max(bulge_a, bulge_b) <= flatness || depth == kDeepest) return segments_meet(a, b);

  // Halve the curve that bulges more
  const EdgeCurve& split = bulge_a >= bulge_b ? a : b;
  const EdgeCurve& other = bulge_a >= bulge_b ? b : a;
  return split_curves_meet(split.part(0.0, 0.5), other, flatness, depth + 1) ||
         split_curves_meet(split.part(0.5, 1.0), other, flatness, depth + 1);
}

}  // namespace

Point2 EdgeCurve::point(double t) const {
  const double s = 1.0 - t;
  return s * s * start + 2.0 * s * t * control + t * t * end;
}

Point2 EdgeCurve::tangent(double t) const {
  return 2.0 * ((1.0 - t) * (control - start) + t * (end - control));
}

Box EdgeCurve::box(double margin) const {
  return {start.cwiseMin(control).cwiseMin(end).array() - margin,
          start.cwiseMax(control).cwiseMax(end).array() + margin};
}

EdgeCurve EdgeCurve::part(double from, double to) const {
  const Point2 first = point(from);
  return {first, first + 0.5 * (to - from) * tangent(from), point(to)};
}

EdgeCurve edge_curve(const ElementNodes& points, int side) {
  const Point2 start = points.col(side), end = points.col((side + 1) % 4);
  return {start, 2.0 * points.col(4 + side) - 0.5 * (start + end), end};
}

Box element_box(const ElementNodes& points) {
  Box around = edge_curve(points, 0).box(0.0);
  for (int side = 1; side < 4; ++side) {
    const Box box = edge_curve(points, side).box(0.0);
    around = {around.lower.cwiseMin(box.lower), around.upper.cwiseMax(box.upper)};
  }
  return around;
}

Point2 edge_parametric(int side, double t) {
  const double along = 2.0 * t - 1.0;
  switch (side) {
    case 0:
      return {along, -1.0};
    case 1:
      return {1.0, along};
    case 2:
      return {-along, 1.0};
    default:
      return {-1.0, -along};
  }
}

NearestPoint nearest_point(const EdgeCurve& curve, const Point2& point) {
  // Sample, and bracket the nearest place between the neighbours of the best sample
  constexpr int kSamples = 8;
  int best = 0;
  double best_square = INFINITY;
  for (int i = 0; i <= kSamples; ++i) {
    const double square = (curve.point(static_cast<double>(i) / kSamples) - point).squaredNorm();
    if (square < best_square) {
      best_square = square;
      best = i;
    }
  }
  double low = std::max(0.0, (best - 1.0) / kSamples);
  double high = std::min(1.0, (best + 1.0) / kSamples);

  // Solve (x(t) - p)·x'(t) = 0 by Newton, by bisection where a step leaves the bracket
  const Point2 second = 2.0 * (curve.start - 2.0 * curve.control + curve.end);
  double t = static_cast<double>(best) / kSamples;
  for (int step = 0; step < 60; ++step) {
    const Point2 offset = curve.point(t) - point, tangent = curve.tangent(t);
    const double slope = offset.dot(tangent);
    (slope > 0.0 ? high : low) = t;
    const double curvature = tangent.squaredNorm() + offset.dot(second);
    double next = curvature > 0.0 ? t - slope / curvature : 0.5 * (low + high);
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double change = std::abs(next - t);
    t = next;
    if (change < 1e-15) break;
  }

  // Take the ends of the edge where they are nearer
  NearestPoint nearest{t, (curve.point(t) - point).norm()};
  for (const double end : {0.0, 1.0}) {
    const double distance = (curve.point(end) - point).norm();
    if (distance < nearest.distance) nearest = {end, distance};
  }
  return nearest;
}

bool curves_meet(const EdgeCurve& a, const EdgeCurve& b, double flatness) {
  return split_curves_meet(a, b, flatness, 0);
}

}  // namespace floe::mesh
