#include <floe/mesh/point_locator.hpp>
#include <floe/mesh/shape_functions.hpp>
#include <floe/numeric/error.hpp>
#include <floe/response/stations.hpp>

#include <sstream>
#include <vector>

namespace floe::response {
namespace {

mesh::ElementPoint require_place(const mesh::Q8Mesh& mesh, const mesh::PointLocator& locator,
                                 const Point2& point, const std::string& name) {
  const auto found = locator.locate(point);
  FLOE_VALIDATE(found.has_value(), point_off_plates(mesh, point, name));
  return *found;
}

}  // namespace

std::vector<Index> elements_at(const mesh::Q8Mesh& mesh, const Points2& points,
                               std::span<const std::string> names) {
  const mesh::PointLocator locator(mesh);
  std::vector<Index> elements;
  for (Index i = 0; i < points.cols(); ++i)
    elements.push_back(require_place(mesh, locator, points.col(i), names[i]).element);
  return elements;
}

std::string point_off_plates(const mesh::Q8Mesh& mesh, const Point2& point,
                             const std::string& name) {
  std::ostringstream text;
  text << "invalid point " << name << " = [" << point.x() << ", " << point.y()
       << "] m (must lie on a plate; the mesh spans x = " << mesh.lower().x() << " … "
       << mesh.upper().x() << " m, y = " << mesh.lower().y() << " … " << mesh.upper().y() << " m)";
  return text.str();
}

SparseMatrix interpolation_to(const mesh::Q8Mesh& mesh, const Points2& points,
                              std::span<const std::string> names) {
  FLOE_EXPECT(static_cast<Index>(names.size()) == points.cols());
  const mesh::PointLocator locator(mesh);
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  for (Index i = 0; i < points.cols(); ++i) {
    const mesh::ElementPoint found = require_place(mesh, locator, points.col(i), names[i]);
    const mesh::Shape8 shape = mesh::q8_shape(found.xi, found.eta);
    for (int a = 0; a < 8; ++a)
      entries.emplace_back(i, mesh.elements()(a, found.element), shape[a]);
  }
  SparseMatrix interpolation(points.cols(), mesh.node_count());
  interpolation.setFromTriplets(entries.begin(), entries.end());
  return interpolation;
}

Points2 line_stations(const Point2& from, const Point2& to, int count) {
  Points2 stations(2, count);
  for (int i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
    stations.col(i) = (1.0 - share) * from + share * to;
  }
  return stations;
}

}  // namespace floe::response
