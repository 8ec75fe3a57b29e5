#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <span>
#include <vector>

namespace floe::mesh {

/// One side of one element; the sides with the same two corners form an edge of the mesh.
struct HalfEdge {
  Index low;  ///< its corners, the lower node number first
  Index high;
  Index middle;  ///< its mid-side node
  Index element;
  int side;     ///< 0 … 3, from corner `side` to the next one
  bool rising;  ///< the element runs from `low` to `high`
};

/// All sides of all elements, sorted so that those of one edge stand together, by element.
std::vector<HalfEdge> sorted_half_edges(const Connectivity& elements);

/// Calls visit(span of the half-edges of one edge) for every edge.
template <typename Visit>
void for_each_edge(std::span<const HalfEdge> half_edges, const Visit& visit) {
  for (std::size_t first = 0, last = 0; first < half_edges.size(); first = last) {
    while (last < half_edges.size() && half_edges[last].low == half_edges[first].low &&
           half_edges[last].high == half_edges[first].high)
      ++last;
    visit(half_edges.subspan(first, last - first));
  }
}

/// No element stands twice.
void check_duplicate_elements(const Points2& nodes, const Connectivity& elements,
                              const MeshLabels& labels);

/// An edge belongs to one element, or to two on its two sides, with one mid-side node; a mid-side
/// node belongs to one edge and is nobody's corner.
void check_edges(const Points2& nodes, const Connectivity& elements,
                 std::span<const HalfEdge> half_edges, const MeshLabels& labels);

}  // namespace floe::mesh
