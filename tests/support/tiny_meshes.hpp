#pragma once

#include <floe/mesh/q8_mesh.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/error.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

/// Small meshes that tests share, as raw arrays so that a test can spoil them before they are
/// validated.
namespace floe::test {

struct MeshArrays {
  Points2 nodes;
  mesh::Connectivity elements;

  mesh::Q8Mesh build() const { return mesh::Q8Mesh(nodes, elements); }
};

/// nx × ny equal elements over length × width [m], centred on the origin.
inline MeshArrays rectangle_arrays(int nx, int ny, double length, double width) {
  const mesh::Q8Mesh mesh =
      mesh::make_rectangle({.length = length, .width = width, .nx = nx, .ny = ny});
  return {mesh.nodes(), mesh.elements()};
}

/// A 60 m × 20 m plate of 6 × 2 elements.
inline mesh::Q8Mesh tiny_plate() { return rectangle_arrays(6, 2, 60.0, 20.0).build(); }

/// The arrays with every node moved by `map`, a function of a Point2.
template <typename Map>
MeshArrays mapped(MeshArrays arrays, const Map& map) {
  for (Index n = 0; n < arrays.nodes.cols(); ++n)
    arrays.nodes.col(n) = map(Point2(arrays.nodes.col(n)));
  return arrays;
}

inline MeshArrays shifted(const MeshArrays& arrays, double dx, double dy) {
  return mapped(arrays, [=](const Point2& p) { return Point2(p.x() + dx, p.y() + dy); });
}

/// Both meshes side by side, nothing merged.
inline MeshArrays joined(const MeshArrays& a, const MeshArrays& b) {
  MeshArrays both;
  both.nodes.resize(2, a.nodes.cols() + b.nodes.cols());
  both.nodes << a.nodes, b.nodes;
  both.elements.resize(8, a.elements.cols() + b.elements.cols());
  both.elements << a.elements, (b.elements.array() + a.nodes.cols()).matrix();
  return both;
}

/// Ring of `around` × `across` curved elements between two radii [m].
inline MeshArrays ring_arrays(double inner, double outer, int around, int across) {
  const MeshArrays strip = rectangle_arrays(around, across, 1.0, 1.0);
  MeshArrays ring = mapped(strip, [&](const Point2& p) {
    const double radius = inner + (outer - inner) * (0.5 + p.y());
    const double angle = -2.0 * std::numbers::pi * p.x();
    return Point2(radius * std::cos(angle), radius * std::sin(angle));
  });

  // Merge the nodes of the seam: those at x = 1/2 become those at x = -1/2
  std::vector<Index> number(strip.nodes.cols(), -1);
  Index count = 0;
  for (Index n = 0; n < strip.nodes.cols(); ++n)
    if (strip.nodes(0, n) < 0.5) {
      ring.nodes.col(count) = ring.nodes.col(n);
      number[n] = count++;
    }
  for (Index n = 0; n < strip.nodes.cols(); ++n)
    for (Index m = 0; m < strip.nodes.cols() && number[n] < 0; ++m)
      if (strip.nodes(0, m) == -0.5 && strip.nodes(1, m) == strip.nodes(1, n))
        number[n] = number[m];
  ring.nodes.conservativeResize(2, count);
  for (Index& n : ring.elements.reshaped()) n = number[n];
  return ring;
}

/// The message of the MeshError that the arrays give; "" if they are accepted.
inline std::string error_of(const MeshArrays& arrays) {
  try {
    arrays.build();
  } catch (const MeshError& error) {
    return error.what();
  }
  return "";
}

/// The point (r, φ) of the plane for (x, y) = (φ, r)
inline Point2 bent(const Point2& p) {
  const double radius = 100.0 + p.y();
  return {radius * std::sin(p.x() / 100.0), radius * std::cos(p.x() / 100.0)};
}

inline Point2 rotated(const Point2& p) {
  return {0.8 * p.x() - 0.6 * p.y(), 0.6 * p.x() + 0.8 * p.y()};
}

}  // namespace floe::test
