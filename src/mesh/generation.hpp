#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <functional>
#include <string>

namespace floe::mesh {

/// Throws InputError unless `value` [m] is positive and finite; `what` is its name in the message.
void demand_positive(double value, const std::string& what);

/// Number of equal parts of `length` that are no longer than `part`.
/// Throws InputError if they are more than 1e8.
int count_parts(double length, double part, const std::string& what);

/// Throws InputError on more than 1e8 elements.
void demand_few_elements(double count, const std::string& what);

/// True if `count` equal parts of `length` are such that `other` is a whole number of them, to
/// 1e-9 of a part.
bool fits(double other, double length, int count);

/// Nodes and elements while a mesh is being made.
struct MeshBuilder {
  std::vector<Point2> nodes;
  std::vector<Eigen::Matrix<Index, 8, 1>> elements;

  Index add_node(const Point2& point);
  Q8Mesh finish() const;
};

/// Adds elements around the origin in layers: `around` elements a layer, `layers` of them. The
/// innermost nodes, 2 · around of them counter-clockwise from a corner, are there already; `place`
/// gives the others by half steps around, 0 … 2 around - 1, and outwards, 1 … 2 layers.
void add_layers(MeshBuilder& builder, const std::vector<Index>& innermost, int layers,
                const std::function<Point2(int, int)>& place);

}  // namespace floe::mesh
