#pragma once

#include <floe/mesh/rectangle.hpp>

#include <cmath>

namespace floe::bench {

/// A 5 : 1 plate of 300 × 60 m whose elements all differ: edges curved by a smooth map.
inline mesh::Q8Mesh curved_plate(int nx) {
  const mesh::Q8Mesh plain =
      mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = nx, .ny = nx / 5});
  Points2 nodes = plain.nodes();
  for (Index i = 0; i < nodes.cols(); ++i) {
    const double x = nodes(0, i), y = nodes(1, i);
    nodes(0, i) += 1.5 * std::sin(y / 11.0) + 2.0 * std::sin(x / 37.0);
    nodes(1, i) += 1.0 * std::sin(x / 23.0) + 0.7 * std::sin(y / 9.0 + x / 50.0);
  }
  return {nodes, plain.elements()};
}

}  // namespace floe::bench
