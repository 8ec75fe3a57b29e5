#pragma once

#include "bem/far_rules.hpp"
#include "bem/quadrature_points.hpp"

namespace floe::bem {

/// Distance of a point from an element whose edges are taken as two straight halves; 0 inside.
double distance_to_element(const Point2& point, const ElementNodes& nodes);

/// Adds the points of an element that lies close to `target` but does not hold it: the element is
/// halved in its longer direction until every cell is as far away as the highest order needs (B.4).
void add_near_points(const Point2& target, const ElementNodes& nodes, double wavenumber,
                     const FarRules& rules, QuadraturePoints& points);

/// Adds the points of an element that holds its target at (ξ, η): triangles with their apex there,
/// the radial coordinate as τ³ against t log t (B.5), the coordinate along the far edge by sinh
/// against the peak of 1/R in stretched elements (B.6), radial panels that double from R =
/// `smallest_scale`, the depth or a radian of wave, where G changes its shape (B.7).
void add_singular_points(const ElementNodes& nodes, double xi, double eta, double smallest_scale,
                         int order, QuadraturePoints& points);

}  // namespace floe::bem
