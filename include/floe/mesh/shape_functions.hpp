#pragma once

#include <Eigen/Core>

namespace floe::mesh {

/// Node order of a Q8 element: corners 0–3 counter-clockwise from (ξ, η) = (-1, -1), then the
/// mid-sides 4–7, node 4 between corners 0 and 1 and so on (the order of Gmsh and of VTK).
using Shape8 = Eigen::Matrix<double, 8, 1>;
using ShapeGradient8 = Eigen::Matrix<double, 2, 8>;  ///< rows ∂/∂ξ, ∂/∂η

/// Parametric coordinates (ξ, η) of the eight nodes, one a column.
const Eigen::Matrix<double, 2, 8>& q8_parametric_nodes();

/// The eight serendipity functions at (ξ, η): 1 at their own node, 0 at the others, sum 1.
inline Shape8 q8_shape(double xi, double eta) {
  const double xm = 1.0 - xi, xp = 1.0 + xi, em = 1.0 - eta, ep = 1.0 + eta;
  Shape8 n;
  n << 0.25 * xm * em * (-xi - eta - 1.0), 0.25 * xp * em * (xi - eta - 1.0),
      0.25 * xp * ep * (xi + eta - 1.0), 0.25 * xm * ep * (-xi + eta - 1.0), 0.5 * xm * xp * em,
      0.5 * em * ep * xp, 0.5 * xm * xp * ep, 0.5 * em * ep * xm;
  return n;
}

/// Their derivatives with respect to ξ and η.
inline ShapeGradient8 q8_shape_gradient(double xi, double eta) {
  const double xm = 1.0 - xi, xp = 1.0 + xi, em = 1.0 - eta, ep = 1.0 + eta;
  ShapeGradient8 d;
  d << 0.25 * em * (2.0 * xi + eta), 0.25 * em * (2.0 * xi - eta), 0.25 * ep * (2.0 * xi + eta),
      0.25 * ep * (2.0 * xi - eta), -xi * em, 0.5 * em * ep, -xi * ep, -0.5 * em * ep,
      0.25 * xm * (xi + 2.0 * eta), 0.25 * xp * (2.0 * eta - xi), 0.25 * xp * (xi + 2.0 * eta),
      0.25 * xm * (2.0 * eta - xi), -0.5 * xm * xp, -eta * xp, 0.5 * xm * xp, -eta * xm;
  return d;
}

}  // namespace floe::mesh
