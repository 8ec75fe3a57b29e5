#include "mesh/pieces.hpp"

#include "mesh/culprits.hpp"

#include <numeric>

namespace floe::mesh {
namespace {

// Root of an element's tree; the path is shortened on the way
Index find_root(std::vector<Index>& parent, Index element) {
  while (parent[element] != element) element = parent[element] = parent[parent[element]];
  return element;
}

}  // namespace

Pieces find_pieces(const Points2& nodes, const Connectivity& elements,
                   std::span<const HalfEdge> half_edges, const MeshLabels& labels) {
  // Join elements across their edges; the root is the first element of its piece
  std::vector<Index> parent(elements.cols());
  std::iota(parent.begin(), parent.end(), Index{0});
  for_each_edge(half_edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() < 2) return;
    const Index a = find_root(parent, edge[0].element), b = find_root(parent, edge[1].element);
    parent[std::max(a, b)] = std::min(a, b);
  });

  // Number the pieces and hand the numbers to elements and nodes
  Pieces pieces;
  pieces.of_element.resize(elements.cols());
  pieces.of_node.assign(nodes.cols(), -1);
  Culprits culprits;
  for (Index e = 0; e < elements.cols(); ++e) {
    const Index root = find_root(parent, e);
    pieces.of_element[e] = root == e ? pieces.count++ : pieces.of_element[root];
    for (int a = 0; a < 8; ++a) {
      int& piece = pieces.of_node[elements(a, e)];
      if (piece >= 0 && piece != pieces.of_element[e])
        culprits.add("node ", labels.node(elements(a, e)), " at ", at(nodes.col(elements(a, e))),
                     " of element ", labels.element(e));
      piece = pieces.of_element[e];
    }
  }
  culprits.throw_if_any("joints at a single node", "pieces must share a whole edge or lie apart");
  return pieces;
}

}  // namespace floe::mesh
