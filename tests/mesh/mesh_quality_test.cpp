#include "tiny_meshes.hpp"

#include <floe/mesh/mesh_quality.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace floe::mesh {
namespace {

using test::mapped;
using test::rectangle_arrays;

// Differences of coordinates: rounding of a few units of 2^-53 relative to the mesh's size
constexpr double kRounding = 1e-13;

TEST(MeshQuality, IsPerfectForSquares) {
  const MeshQuality quality = measure_quality(rectangle_arrays(8, 4, 8.0, 4.0).build());
  EXPECT_NEAR(quality.shortest_edge, 1.0, kRounding);
  EXPECT_NEAR(quality.longest_edge, 1.0, kRounding);
  EXPECT_NEAR(quality.worst_aspect_ratio, 1.0, 1e-7);  // root of rounding
  EXPECT_NEAR(quality.worst_jacobian_ratio, 1.0, kRounding);
  EXPECT_NEAR(quality.largest_edge_jump, 1.0, kRounding);
}

TEST(MeshQuality, TellsTheAspectRatioOfRectangles) {
  for (const double ratio : {3.0, 25.0, 1000.0}) {
    const MeshQuality flat = measure_quality(rectangle_arrays(2, 2, 2.0 * ratio, 2.0).build());
    EXPECT_NEAR(flat.worst_aspect_ratio, ratio, 1e-9 * ratio);
    EXPECT_NEAR(flat.longest_edge / flat.shortest_edge, ratio, 1e-9 * ratio);
    EXPECT_NEAR(flat.largest_edge_jump, 1.0, kRounding);
  }
}

// A square stretched by a along one diagonal and by b along the other, its edges equal
TEST(MeshQuality, TellsTheAspectRatioOfARhombus) {
  const auto rhombus = mapped(rectangle_arrays(1, 1, 2.0, 2.0), [](const Point2& p) {
    return Point2(10.0 * (p.x() - p.y()), p.x() + p.y());
  });
  const MeshQuality quality = measure_quality(rhombus.build());
  EXPECT_NEAR(quality.worst_aspect_ratio, 10.0, 1e-9);
  EXPECT_NEAR(quality.shortest_edge, quality.longest_edge, 1e-12);
}

// Trapezium with parallel sides 2 and 1: det J = (3 - η)/4, taken at η = ±√(3/5)
TEST(MeshQuality, TellsTheJacobianRatioOfATrapezium) {
  const auto trapezium = mapped(rectangle_arrays(1, 1, 2.0, 2.0), [](const Point2& p) {
    return Point2(p.x() * (3.0 - p.y()) / 4.0, p.y());
  });
  const double g = std::sqrt(0.6);
  EXPECT_NEAR(measure_quality(trapezium.build()).worst_jacobian_ratio, (3.0 - g) / (3.0 + g),
              1e-14);
}

TEST(MeshQuality, TellsTheJumpBetweenNeighbours) {
  // Columns of 1, 1, 5 and 2 m: the largest jump is from the second to the third
  const auto columns = mapped(rectangle_arrays(4, 1, 4.0, 1.0), [](const Point2& p) {
    const double x = p.x() + 2.0;
    return Point2(x <= 2.0 ? x : x <= 3.0 ? 2.0 + 5.0 * (x - 2.0) : 7.0 + 2.0 * (x - 3.0), p.y());
  });
  const MeshQuality quality = measure_quality(columns.build());
  EXPECT_NEAR(quality.largest_edge_jump, 5.0, 1e-12);
  EXPECT_EQ(quality.edge_jump_element, 2);
  EXPECT_EQ(quality.edge_jump_neighbour, 1);
  EXPECT_EQ(quality.longest_edge_element, 2);
  EXPECT_NEAR(quality.longest_edge, 5.0, 1e-12);
  EXPECT_NEAR(quality.worst_aspect_ratio, 5.0, 1e-9);
  EXPECT_EQ(quality.worst_aspect_element, 2);
}

TEST(MeshQuality, HasNoJumpForOneElement) {
  const MeshQuality quality = measure_quality(rectangle_arrays(1, 1, 3.0, 2.0).build());
  EXPECT_EQ(quality.largest_edge_jump, 1.0);
  EXPECT_EQ(quality.edge_jump_element, 0);
  EXPECT_EQ(quality.edge_jump_neighbour, 0);
}

// An arc of angle φ as two chords is short by the share φ²/96
TEST(MeshQuality, MeasuresCurvedEdgesThroughTheirMiddle) {
  const double arc = 2.0 * std::numbers::pi / 16;
  const MeshQuality quality = measure_quality(test::ring_arrays(10.0, 30.0, 16, 1).build());
  EXPECT_NEAR(quality.shortest_edge, 40.0 * std::sin(arc / 4.0), 1e-12);
  EXPECT_NEAR(quality.longest_edge, 20.0, 1e-12);
}

}  // namespace
}  // namespace floe::mesh
