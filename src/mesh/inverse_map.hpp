#pragma once

#include "mesh/geometry.hpp"

#include <optional>

namespace floe::mesh {

/// Parametric coordinates (ξ, η) of a point in an element: solves x(ξ, η) = point by Newton with
/// step halving, from the centre and, where that fails in a strongly curved element, from the small
/// squares of the parametric plane whose image can hold the point.
/// Nothing if the point lies outside by more than 1e-8 of the parametric square; what is returned
/// is clamped to the square. The residual is below 1e-12 of the element's extent, or rounding.
std::optional<Point2> find_parametric(const ElementNodes& points, const Point2& point);

}  // namespace floe::mesh
