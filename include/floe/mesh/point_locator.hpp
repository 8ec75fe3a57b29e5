#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <optional>
#include <vector>

namespace floe::mesh {

/// Where a point lies on a mesh.
struct ElementPoint {
  Index element = 0;
  double xi = 0.0;  ///< parametric coordinates in the element, within [-1, 1]
  double eta = 0.0;
};

/// Finds the element that holds a point. Keeps a grid of bins and a view of the mesh, which must
/// outlive it.
class PointLocator {
 public:
  explicit PointLocator(const Q8Mesh& mesh);

  /// The element that holds `point`, edges included, to 1e-6 of the mesh's size (a point that near
  /// outside is moved onto the edge); nothing if it lies on no element.
  std::optional<ElementPoint> locate(const Point2& point) const;

 private:
  const Q8Mesh& mesh_;  // view
  double tolerance_;
  double bin_size_;
  Index bins_x_, bins_y_;
  std::vector<std::vector<Index>> bin_elements_;
};

}  // namespace floe::mesh
