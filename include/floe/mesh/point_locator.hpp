#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <memory>
#include <optional>

namespace floe::mesh {

class BoxTree;

/// Where a point lies on a mesh.
struct ElementPoint {
  Index element = 0;
  double xi = 0.0;  ///< parametric coordinates in the element, within [-1, 1]
  double eta = 0.0;
};

/// Finds the element that holds a point. Keeps a tree of element boxes and a view of the mesh,
/// which must outlive it.
class PointLocator {
 public:
  explicit PointLocator(const Q8Mesh& mesh);

  /// The element that holds `point`, edges included, to 1e-6 of the mesh's size (a point that near
  /// outside is moved onto the edge); nothing if it lies on no element. Where several elements hold
  /// it, the one with the lowest number is taken.
  std::optional<ElementPoint> locate(const Point2& point) const;

  /// Every element that holds `point`, by rising number: several on edges and corners. The same
  /// tolerance as `locate`; empty where that finds nothing.
  std::vector<ElementPoint> locate_all(const Point2& point) const;

 private:
  const Q8Mesh& mesh_;  // view
  double tolerance_;    // [m]
  std::shared_ptr<const BoxTree> tree_;
};

}  // namespace floe::mesh
