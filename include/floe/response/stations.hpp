#pragma once

#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/types.hpp>

#include <span>
#include <string>
#include <vector>

namespace floe::response {

/// Interpolation from nodes to points on a plate: count × N, rows the Q8 functions at each point.
/// Throws InputError naming the points (by `names`, one each) that lie on no element.
SparseMatrix interpolation_to(const mesh::Q8Mesh& mesh, const Points2& points,
                              std::span<const std::string> names);

/// Number of the element that holds each point; the lowest where several do. Throws likewise.
std::vector<Index> elements_at(const mesh::Q8Mesh& mesh, const Points2& points,
                               std::span<const std::string> names);

/// The message about a point that lies on no element.
std::string point_off_plates(const mesh::Q8Mesh& mesh, const Point2& point,
                             const std::string& name);

/// `count` equidistant points from `from` to `to`, both included.
Points2 line_stations(const Point2& from, const Point2& to, int count);

}  // namespace floe::response
