#include <floe/mesh/point_locator.hpp>
#include <floe/mesh/shape_functions.hpp>
#include <floe/numeric/error.hpp>
#include <floe/plate/dry_modes.hpp>
#include <floe/plate/mindlin.hpp>

#include <optional>

namespace floe::plate {

DryModes interpolate_modes(const DryModes& modes, const mesh::Q8Mesh& plate_mesh,
                           const mesh::Q8Mesh& fluid_mesh) {
  FLOE_EXPECT(modes.shape.rows() == kUnknownsPerNode * plate_mesh.node_count());
  const mesh::PointLocator locator(plate_mesh);
  DryModes result = modes;
  result.shape = MatXd::Zero(kUnknownsPerNode * fluid_mesh.node_count(), modes.count());
  for (Index n = 0; n < fluid_mesh.node_count(); ++n) {
    const Point2 point = fluid_mesh.nodes().col(n);
    const std::optional<mesh::ElementPoint> place = locator.locate(point);
    FLOE_VALIDATE_AS(MeshError, place.has_value(),
                     "fluid node " << n << " at (" << point.x() << ", " << point.y()
                                   << ") m lies on no element of the plate's mesh (the outlines "
                                      "must be the same)");
    const mesh::Shape8 shape = mesh::q8_shape(place->xi, place->eta);
    for (int a = 0; a < 8; ++a)
      result.shape.middleRows<kUnknownsPerNode>(kUnknownsPerNode * n) +=
          shape[a] * modes.shape.middleRows<kUnknownsPerNode>(
                         kUnknownsPerNode * plate_mesh.elements()(a, place->element));
  }
  return result;
}

}  // namespace floe::plate
