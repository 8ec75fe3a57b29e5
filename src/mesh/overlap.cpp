#include "mesh/overlap.hpp"

#include "mesh/culprits.hpp"
#include "mesh/edge_curve.hpp"
#include "mesh/inverse_map.hpp"

#include <floe/mesh/box_tree.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace floe::mesh {
namespace {

// A boundary edge: its curve, its three nodes and its element
struct BoundaryEdge {
  EdgeCurve curve;
  std::array<Index, 3> nodes;  // start, end, middle
  Index element;

  bool owns(Index node) const { return node == nodes[0] || node == nodes[1] || node == nodes[2]; }
};

std::vector<BoundaryEdge> boundary_edges(const Points2& nodes, const Connectivity& elements,
                                         std::span<const HalfEdge> half_edges) {
  std::vector<BoundaryEdge> boundary;
  for_each_edge(half_edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 1) return;
    const Index e = edge[0].element;
    const int side = edge[0].side;
    boundary.push_back({edge_curve(gather_nodes(nodes, elements, e), side),
                        {elements(side, e), elements((side + 1) % 4, e), edge[0].middle},
                        e});
  });
  return boundary;
}

BoxTree edge_tree(const std::vector<BoundaryEdge>& boundary) {
  std::vector<Box> boxes;
  boxes.reserve(boundary.size());
  for (const BoundaryEdge& edge : boundary) boxes.push_back(edge.curve.box(0.0));
  return BoxTree(boxes);
}

// Angle of an element at a corner, 0 to 2π, from the tangents of the two edges that meet there
double corner_angle(const ElementNodes& points, int corner) {
  const EdgeCurve leaving = edge_curve(points, corner);
  const EdgeCurve arriving = edge_curve(points, (corner + 3) % 4);
  const Point2 out = leaving.tangent(0.0), back = -arriving.tangent(1.0);
  const double angle = std::atan2(cross(out, back), out.dot(back));
  // A cusp may come out as a tiny negative angle, which is not a full turn
  return angle < -0.1 ? angle + 2.0 * std::numbers::pi : std::max(angle, 0.0);
}

void check_angles(const Points2& nodes, const Connectivity& elements, const MeshLabels& labels) {
  std::vector<double> sum(nodes.cols(), 0.0);
  for (Index e = 0; e < elements.cols(); ++e) {
    const ElementNodes points = gather_nodes(nodes, elements, e);
    for (int corner = 0; corner < 4; ++corner)
      sum[elements(corner, e)] += corner_angle(points, corner);
  }
  // Sums are right to rounding; less than 0.01 too much shows where the edges cross
  Culprits culprits;
  for (Index n = 0; n < nodes.cols(); ++n)
    if (sum[n] > 2.0 * std::numbers::pi + 0.01)
      culprits.add("node ", labels.node(n), " at ", at(nodes.col(n)), " with ",
                   sum[n] * 180.0 / std::numbers::pi, " degrees");
  culprits.throw_if_any("nodes with overlapping elements",
                        "the elements around a node must fill 360 degrees at most");
}

void check_hanging_nodes(const Points2& nodes, const std::vector<BoundaryEdge>& boundary,
                         const BoxTree& tree, double tolerance, const MeshLabels& labels) {
  Culprits culprits;
  for (const BoundaryEdge& owner : boundary)
    for (const int which : {0, 2}) {  // the end is the start of the next edge
      const Index node = owner.nodes[which];
      const Point2 place = nodes.col(node);
      if (culprits.full()) break;
      tree.visit(box_around(place, tolerance), [&](Index i) {
        const BoundaryEdge& edge = boundary[i];
        if (edge.owns(node) || nearest_point(edge.curve, place).distance > tolerance) return;
        culprits.add("node ", labels.node(node), " at ", at(place), " of element ",
                     labels.element(owner.element), " on an edge of element ",
                     labels.element(edge.element));
      });
    }
  culprits.throw_if_any("hanging nodes", "elements must meet along whole edges", true);
}

// Whether two boundary edges cross; a node that both own is no crossing
bool edges_cross(const BoundaryEdge& a, const BoundaryEdge& b, double flatness) {
  constexpr double kCut = 1.0 / 64.0;
  const auto without_shared_end = [](const BoundaryEdge& edge, const BoundaryEdge& other) {
    return edge.curve.part(other.owns(edge.nodes[0]) ? kCut : 0.0,
                           other.owns(edge.nodes[1]) ? 1.0 - kCut : 1.0);
  };
  if (!a.owns(b.nodes[0]) && !a.owns(b.nodes[1])) return curves_meet(a.curve, b.curve, flatness);
  return curves_meet(without_shared_end(a, b), b.curve, flatness) ||
         curves_meet(a.curve, without_shared_end(b, a), flatness);
}

void check_crossing_edges(const std::vector<BoundaryEdge>& boundary, const BoxTree& tree,
                          double tolerance, const MeshLabels& labels) {
  Culprits culprits;
  for (Index i = 0; i < static_cast<Index>(boundary.size()) && !culprits.full(); ++i)
    tree.visit(boundary[i].curve.box(0.0), [&](Index j) {
      if (j <= i || culprits.full()) return;
      if (!edges_cross(boundary[i], boundary[j], 1e-3 * tolerance)) return;
      culprits.add("elements ", labels.element(boundary[i].element), " and ",
                   labels.element(boundary[j].element), " at ", at(boundary[i].curve.point(0.5)));
    });
  culprits.throw_if_any("overlapping elements", "their edges must not cross", true);
}

void check_buried_nodes(const Points2& nodes, const Connectivity& elements,
                        const std::vector<BoundaryEdge>& boundary, const MeshLabels& labels) {
  std::vector<Box> boxes;
  for (Index e = 0; e < elements.cols(); ++e)
    boxes.push_back(element_box(gather_nodes(nodes, elements, e)));
  const BoxTree tree(boxes);
  Culprits culprits;
  for (const BoundaryEdge& owner : boundary) {
    const Index node = owner.nodes[0];
    if (culprits.full()) break;
    tree.visit(box_around(nodes.col(node), 0.0), [&](Index e) {
      if ((elements.col(e).array() == node).any() || culprits.full()) return;
      if (!find_parametric(gather_nodes(nodes, elements, e), nodes.col(node))) return;
      culprits.add("elements ", labels.element(owner.element), " and ", labels.element(e), " at ",
                   at(nodes.col(node)));
    });
  }
  culprits.throw_if_any("overlapping elements", "none may lie on another", true);
}

}  // namespace

void check_overlap(const Points2& nodes, const Connectivity& elements,
                   std::span<const HalfEdge> half_edges, double tolerance,
                   const MeshLabels& labels) {
  check_angles(nodes, elements, labels);
  const std::vector<BoundaryEdge> boundary = boundary_edges(nodes, elements, half_edges);
  const BoxTree tree = edge_tree(boundary);
  check_hanging_nodes(nodes, boundary, tree, tolerance, labels);
  check_crossing_edges(boundary, tree, tolerance, labels);
  check_buried_nodes(nodes, elements, boundary, labels);
}

}  // namespace floe::mesh
