#include "mesh/half_edges.hpp"

#include <floe/mesh/drawing.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace floe::mesh {
namespace {

// Corners and mid-sides of an element, turning left
constexpr int kTriangles[6][3] = {{0, 4, 7}, {4, 1, 5}, {5, 2, 6}, {6, 3, 7}, {4, 5, 6}, {4, 6, 7}};

using NodePair = std::array<Index, 2>;

// Both halves of every edge that one element has alone
std::vector<NodePair> outline_pairs(const Q8Mesh& mesh) {
  std::vector<NodePair> pairs;
  const std::vector<HalfEdge> half_edges = sorted_half_edges(mesh.elements());
  for_each_edge(half_edges, [&](std::span<const HalfEdge> sides) {
    if (sides.size() != 1) return;
    pairs.push_back({sides[0].low, sides[0].middle});
    pairs.push_back({sides[0].middle, sides[0].high});
  });
  return pairs;
}

// The node that stands for each node: itself, or the best one of its cell
std::vector<Index> representatives(const Q8Mesh& mesh, Index most_nodes,
                                   const std::vector<NodePair>& outline) {
  std::vector<Index> standing(static_cast<std::size_t>(mesh.node_count()));
  for (std::size_t n = 0; n < standing.size(); ++n) standing[n] = static_cast<Index>(n);
  if (mesh.node_count() <= most_nodes) return standing;
  std::vector<char> on_outline(standing.size(), 0);
  for (const NodePair& pair : outline)
    for (const Index node : pair) on_outline[static_cast<std::size_t>(node)] = 1;

  const double cell = std::sqrt(mesh.area() / static_cast<double>(most_nodes));
  using Key = std::tuple<int, Index, Index>;
  struct Best {
    Index node = -1;
    double badness = std::numeric_limits<double>::infinity();
  };
  std::map<Key, Best> cells;
  const auto key_of = [&](Index n) {
    const Point2 at = (mesh.nodes().col(n) - mesh.lower()) / cell;
    return Key{mesh.node_piece()[static_cast<std::size_t>(n)],
               static_cast<Index>(std::floor(at.x())), static_cast<Index>(std::floor(at.y()))};
  };
  for (Index n = 0; n < mesh.node_count(); ++n) {
    const Key key = key_of(n);
    const Point2 centre = mesh.lower() + cell * Point2(static_cast<double>(std::get<1>(key)) + 0.5,
                                                       static_cast<double>(std::get<2>(key)) + 0.5);
    const double inside = on_outline[static_cast<std::size_t>(n)] != 0 ? 0.0 : 2.0 * cell;
    const double badness = (mesh.nodes().col(n) - centre).norm() + inside;
    Best& best = cells[key];
    if (badness < best.badness) best = {n, badness};
  }
  for (std::size_t n = 0; n < standing.size(); ++n)
    standing[n] = cells[key_of(static_cast<Index>(n))].node;
  return standing;
}

template <typename Shape>
void sort_unique(std::vector<Shape>& shapes) {
  std::sort(shapes.begin(), shapes.end());
  shapes.erase(std::unique(shapes.begin(), shapes.end()), shapes.end());
}

}  // namespace

Drawing make_drawing(const Q8Mesh& mesh, Index most_nodes) {
  const std::vector<NodePair> pairs = outline_pairs(mesh);
  const std::vector<Index> standing = representatives(mesh, most_nodes, pairs);
  const auto stand = [&](Index node) { return standing[static_cast<std::size_t>(node)]; };

  // Number the nodes that are left
  Drawing drawing;
  drawing.nodes = standing;
  sort_unique(drawing.nodes);
  std::vector<std::uint32_t> position(standing.size(), 0);
  for (std::size_t i = 0; i < drawing.nodes.size(); ++i)
    position[static_cast<std::size_t>(drawing.nodes[i])] = static_cast<std::uint32_t>(i);
  const auto drawn = [&](Index node) { return position[static_cast<std::size_t>(stand(node))]; };

  // Keep the triangles and edges that did not shrink to less
  for (Index e = 0; e < mesh.element_count(); ++e)
    for (const auto& triangle : kTriangles) {
      std::array<std::uint32_t, 3> t = {drawn(mesh.elements()(triangle[0], e)),
                                        drawn(mesh.elements()(triangle[1], e)),
                                        drawn(mesh.elements()(triangle[2], e))};
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      drawing.triangles.push_back(t);
    }
  for (const NodePair& pair : pairs) {
    const std::uint32_t a = drawn(pair[0]), b = drawn(pair[1]);
    if (a != b) drawing.outline.push_back({std::min(a, b), std::max(a, b)});
  }
  sort_unique(drawing.triangles);
  sort_unique(drawing.outline);
  return drawing;
}

}  // namespace floe::mesh
