#pragma once

#include <floe/mesh/rectangle.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <vector>

/// Outlines of equal elements, and smooth right-hand sides on them.
namespace floe::test {

/// The cells of an nx × ny lattice of cells step_x × step_y [m] that `keep(i, j)` chooses, centred.
inline mesh::Q8Mesh lattice_mesh(int nx, int ny, double step_x, double step_y,
                                 const std::function<bool(int, int)>& keep) {
  const mesh::Q8Mesh full =
      mesh::make_rectangle({.length = step_x * nx, .width = step_y * ny, .nx = nx, .ny = ny});
  std::vector<Index> kept;
  std::set<Index> used;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      if (keep(i, j)) kept.push_back(static_cast<Index>(j) * nx + i);
  for (const Index e : kept)
    for (int a = 0; a < 8; ++a) used.insert(full.elements()(a, e));
  std::vector<Index> number(static_cast<std::size_t>(full.node_count()), -1);
  Points2 nodes(2, static_cast<Index>(used.size()));
  Index next = 0;
  for (const Index node : used) {
    nodes.col(next) = full.nodes().col(node);
    number[static_cast<std::size_t>(node)] = next++;
  }
  mesh::Connectivity elements(8, static_cast<Index>(kept.size()));
  for (std::size_t e = 0; e < kept.size(); ++e)
    for (int a = 0; a < 8; ++a)
      elements(a, static_cast<Index>(e)) =
          number[static_cast<std::size_t>(full.elements()(a, kept[e]))];
  return {nodes, elements};
}

/// cos(mπx/L) cos(nπy/B) over the bounding box at the nodes, the `count` lowest wavenumbers.
inline MatXcd smooth_modes(const mesh::Q8Mesh& mesh, Index count) {
  const Point2 size = mesh.upper() - mesh.lower();
  struct Mode {
    double wavenumber, kx, ky;
  };
  std::vector<Mode> modes;
  for (Index m = 0; m < count; ++m)
    for (Index n = 0; n < count; ++n) {
      const double kx = std::numbers::pi * double(m) / size.x(),
                   ky = std::numbers::pi * double(n) / size.y();
      modes.push_back({std::hypot(kx, ky), kx, ky});
    }
  std::stable_sort(modes.begin(), modes.end(),
                   [](const Mode& a, const Mode& b) { return a.wavenumber < b.wavenumber; });
  MatXcd value(mesh.node_count(), count);
  for (Index c = 0; c < count; ++c)
    for (Index i = 0; i < mesh.node_count(); ++i) {
      const Point2 p = mesh.nodes().col(i) - mesh.lower();
      value(i, c) = std::cos(modes[static_cast<std::size_t>(c)].kx * p.x()) *
                    std::cos(modes[static_cast<std::size_t>(c)].ky * p.y());
    }
  return value;
}

}  // namespace floe::test
