#include "tiny_meshes.hpp"

#include <floe/mesh/drawing.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace floe::mesh {
namespace {

double area(const Q8Mesh& mesh, const Drawing& drawing) {
  double sum = 0.0;
  for (const auto& t : drawing.triangles) {
    const Point2 a = mesh.nodes().col(drawing.nodes[t[0]]),
                 b = mesh.nodes().col(drawing.nodes[t[1]]),
                 c = mesh.nodes().col(drawing.nodes[t[2]]);
    sum += 0.5 * ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x());
  }
  return sum;
}

TEST(Drawing, OfASmallMeshHasEveryNodeAndTheWholeArea) {
  const Q8Mesh mesh = test::tiny_plate();
  const Drawing drawing = make_drawing(mesh, 1000);
  EXPECT_EQ(static_cast<Index>(drawing.nodes.size()), mesh.node_count());
  EXPECT_EQ(static_cast<Index>(drawing.triangles.size()), 6 * mesh.element_count());
  EXPECT_EQ(drawing.outline.size(), 2u * (6 + 2) * 2);
  EXPECT_NEAR(area(mesh, drawing), 1200.0, 1e-9);
}

TEST(Drawing, OfALargeMeshIsThinnedOutAndKeepsItsOutline) {
  const Q8Mesh mesh = test::rectangle_arrays(150, 60, 300.0, 120.0).build();
  const Drawing drawing = make_drawing(mesh, 2000);
  EXPECT_LT(drawing.nodes.size(), 3000u);
  EXPECT_GT(drawing.nodes.size(), 1500u);
  EXPECT_NEAR(area(mesh, drawing), 36000.0, 0.01 * 36000.0);
  double length = 0.0;
  for (const auto& edge : drawing.outline)
    length += (mesh.nodes().col(drawing.nodes[edge[0]]) - mesh.nodes().col(drawing.nodes[edge[1]]))
                  .norm();
  EXPECT_NEAR(length, 840.0, 0.02 * 840.0);
}

TEST(Drawing, KeepsPiecesApart) {
  const auto piece = test::rectangle_arrays(40, 40, 10.0, 10.0);
  const Q8Mesh mesh = test::joined(piece, test::shifted(piece, 10.001, 0.0)).build();
  const Drawing drawing = make_drawing(mesh, 400);
  for (const auto& t : drawing.triangles) {
    std::set<int> pieces;
    for (const auto corner : t)
      pieces.insert(mesh.node_piece()[static_cast<std::size_t>(drawing.nodes[corner])]);
    EXPECT_EQ(pieces.size(), 1u);
  }
}

}  // namespace
}  // namespace floe::mesh
