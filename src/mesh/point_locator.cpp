#include "mesh/edge_curve.hpp"
#include "mesh/inverse_map.hpp"

#include <floe/mesh/box_tree.hpp>
#include <floe/mesh/point_locator.hpp>

namespace floe::mesh {
namespace {

BoxTree element_tree(const Q8Mesh& mesh) {
  std::vector<Box> boxes;
  for (Index e = 0; e < mesh.element_count(); ++e)
    boxes.push_back(element_box(mesh.element_nodes(e)));
  return BoxTree(boxes);
}

// Where the element holds the point; or the nearest place of its edges, if that is within
// `tolerance`
std::optional<ElementPoint> hold(const Q8Mesh& mesh, Index element, const Point2& point,
                                 double tolerance) {
  const ElementNodes nodes = mesh.element_nodes(element);
  if (const auto found = find_parametric(nodes, point))
    return ElementPoint{element, found->x(), found->y()};
  for (int side = 0; side < 4; ++side) {
    const NearestPoint nearest = nearest_point(edge_curve(nodes, side), point);
    if (nearest.distance > tolerance) continue;
    const Point2 parametric = edge_parametric(side, nearest.t);
    return ElementPoint{element, parametric.x(), parametric.y()};
  }
  return std::nullopt;
}

}  // namespace

PointLocator::PointLocator(const Q8Mesh& mesh)
    : mesh_(mesh),
      tolerance_(kRelativeTolerance * mesh.size()),
      tree_(std::make_shared<const BoxTree>(element_tree(mesh))) {}

std::optional<ElementPoint> PointLocator::locate(const Point2& point) const {
  if (!point.allFinite()) return std::nullopt;
  const std::vector<Index> candidates = tree_->find(box_around(point, tolerance_));

  // Prefer an element that really holds the point to one that misses it by less than the tolerance
  for (const double tolerance : {0.0, tolerance_})
    for (const Index e : candidates)
      if (const auto found = hold(mesh_, e, point, tolerance)) return found;
  return std::nullopt;
}

std::vector<ElementPoint> PointLocator::locate_all(const Point2& point) const {
  std::vector<ElementPoint> holders;
  if (!point.allFinite()) return holders;
  for (const Index e : tree_->find(box_around(point, tolerance_)))
    if (const auto found = hold(mesh_, e, point, tolerance_)) holders.push_back(*found);
  return holders;
}

}  // namespace floe::mesh
