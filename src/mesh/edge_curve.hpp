#pragma once

#include "mesh/geometry.hpp"

#include <floe/mesh/box_tree.hpp>
#include <floe/mesh/q8_mesh.hpp>

namespace floe::mesh {

/// The edge of a Q8 element, a parabola through its three nodes, as a Bézier curve:
///   x(t) = (1-t)² start + 2t(1-t) control + t² end,  0 <= t <= 1, mid-side node at t = 1/2
struct EdgeCurve {
  Point2 start;
  Point2 control;
  Point2 end;

  Point2 point(double t) const;
  Point2 tangent(double t) const;  ///< dx/dt
  Box box(double margin) const;

  /// The part between two parameters.
  EdgeCurve part(double from, double to) const;
};

/// The edge `side` (0 … 3) of an element, from corner `side` to the next one.
EdgeCurve edge_curve(const ElementNodes& points, int side);

/// Box around an element's edges, and so around the element.
Box element_box(const ElementNodes& points);

/// Parametric coordinates (ξ, η) of the point t of an element's edge.
Point2 edge_parametric(int side, double t);

/// The place on a curve that is nearest to a point.
struct NearestPoint {
  double t = 0.0;
  double distance = 0.0;  ///< [m]
};
NearestPoint nearest_point(const EdgeCurve& curve, const Point2& point);

/// True if the curves have a point in common. Curves are split until lines tell them apart or they
/// are straight to `flatness` [m].
bool curves_meet(const EdgeCurve& a, const EdgeCurve& b, double flatness);

}  // namespace floe::mesh
