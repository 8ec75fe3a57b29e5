#include "mesh/half_edges.hpp"

#include "mesh/culprits.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace floe::mesh {
namespace {

// "3 and 4" or "3, 4 and 9": the elements of an edge, from 1
std::string element_list(std::span<const HalfEdge> edge, const MeshLabels& labels) {
  std::ostringstream text;
  for (std::size_t i = 0; i < edge.size(); ++i)
    text << (i == 0                 ? ""
             : i + 1 == edge.size() ? " and "
                                    : ", ")
         << labels.element(edge[i].element);
  return text.str();
}

// Mid-side nodes that are a corner of another element, or the middle of two edges
void check_middles(const Points2& nodes, const Connectivity& elements,
                   std::span<const HalfEdge> half_edges, const MeshLabels& labels) {
  std::vector<Index> corner_of(nodes.cols(), -1);
  for (Index e = 0; e < elements.cols(); ++e)
    for (int a = 0; a < 4; ++a) corner_of[elements(a, e)] = e;

  Culprits culprits;
  std::vector<Index> middle_of(nodes.cols(), -1);
  for_each_edge(half_edges, [&](std::span<const HalfEdge> edge) {
    const Index node = edge[0].middle;
    const Index other = corner_of[node] >= 0 ? corner_of[node] : middle_of[node];
    if (other >= 0)
      culprits.add("node ", labels.node(node), " at ", at(nodes.col(node)),
                   " in the middle of an edge of element ", labels.element(edge[0].element),
                   " belongs to another edge of element ", labels.element(other));
    middle_of[node] = edge[0].element;
  });
  culprits.throw_if_any("hanging nodes", "elements must meet along whole edges");
}

}  // namespace

std::vector<HalfEdge> sorted_half_edges(const Connectivity& elements) {
  std::vector<HalfEdge> half_edges;
  half_edges.reserve(4 * elements.cols());
  for (Index e = 0; e < elements.cols(); ++e)
    for (int side = 0; side < 4; ++side) {
      const Index from = elements(side, e), to = elements((side + 1) % 4, e);
      half_edges.push_back(
          {std::min(from, to), std::max(from, to), elements(4 + side, e), e, side, from < to});
    }
  std::sort(half_edges.begin(), half_edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.element, a.side) < std::tie(b.low, b.high, b.element, b.side);
  });
  return half_edges;
}

void check_duplicate_elements(const Points2& nodes, const Connectivity& elements,
                              const MeshLabels& labels) {
  struct Corners {
    std::array<Index, 4> sorted;
    Index element;
  };
  std::vector<Corners> all(elements.cols());
  for (Index e = 0; e < elements.cols(); ++e) {
    std::copy_n(elements.col(e).data(), 4, all[e].sorted.begin());
    std::sort(all[e].sorted.begin(), all[e].sorted.end());
    all[e].element = e;
  }
  std::sort(all.begin(), all.end(), [](const Corners& a, const Corners& b) {
    return std::tie(a.sorted, a.element) < std::tie(b.sorted, b.element);
  });
  Culprits culprits;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].sorted == all[i - 1].sorted)
      culprits.add("elements ", labels.element(all[i - 1].element), " and ",
                   labels.element(all[i].element), " at ",
                   at(nodes.col(elements(0, all[i].element))));
  culprits.throw_if_any("duplicate elements", "each must stand once");
}

void check_edges(const Points2& nodes, const Connectivity& elements,
                 std::span<const HalfEdge> half_edges, const MeshLabels& labels) {
  Culprits crowded, same_side, split;
  for_each_edge(half_edges, [&](std::span<const HalfEdge> edge) {
    const HalfEdge& first = edge[0];
    const auto describe = [&](Culprits& culprits) {
      culprits.add("edge ", labels.node(first.low), "-", labels.node(first.high), " at ",
                   at(nodes.col(first.middle)), " of elements ", element_list(edge, labels));
    };
    if (edge.size() > 2) return describe(crowded);
    if (edge.size() < 2) return;
    if (first.middle != edge[1].middle) describe(split);
    if (first.rising == edge[1].rising) describe(same_side);
  });
  crowded.throw_if_any("edges of more than two elements", "at most two elements meet at an edge");
  same_side.throw_if_any("edges with overlapping elements",
                         "two elements must lie on the two sides of their edge");
  split.throw_if_any("edges with two mid-side nodes", "both elements must use the same one");
  check_middles(nodes, elements, half_edges, labels);
}

}  // namespace floe::mesh
