#include "mesh/box_tree.hpp"
#include "mesh/edge_curve.hpp"
#include "mesh/inverse_map.hpp"

#include <floe/mesh/point_locator.hpp>

namespace floe::mesh {
namespace {

BoxTree element_tree(const Q8Mesh& mesh) {
  std::vector<Box> boxes;
  for (Index e = 0; e < mesh.element_count(); ++e)
    boxes.push_back(element_box(mesh.element_nodes(e)));
  return BoxTree(boxes);
}

}  // namespace

PointLocator::PointLocator(const Q8Mesh& mesh)
    : mesh_(mesh),
      tolerance_(kRelativeTolerance * mesh.size()),
      tree_(std::make_shared<const BoxTree>(element_tree(mesh))) {}

std::optional<ElementPoint> PointLocator::locate(const Point2& point) const {
  if (!point.allFinite()) return std::nullopt;
  const std::vector<Index> candidates = tree_->find(box_around(point, tolerance_));

  // Take the first element that holds the point
  for (const Index e : candidates)
    if (const auto found = find_parametric(mesh_.element_nodes(e), point))
      return ElementPoint{e, found->x(), found->y()};

  // Take the first that it misses by less than the tolerance, and move it onto the edge
  for (const Index e : candidates)
    for (int side = 0; side < 4; ++side) {
      const NearestPoint nearest = nearest_point(edge_curve(mesh_.element_nodes(e), side), point);
      if (nearest.distance > tolerance_) continue;
      const Point2 parametric = edge_parametric(side, nearest.t);
      return ElementPoint{e, parametric.x(), parametric.y()};
    }
  return std::nullopt;
}

}  // namespace floe::mesh
