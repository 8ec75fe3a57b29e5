#include "tiny_meshes.hpp"

#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <string>

namespace floe::mesh {
namespace {

using test::bent;
using test::error_of;
using test::joined;
using test::mapped;
using test::MeshArrays;
using test::rectangle_arrays;
using test::ring_arrays;
using test::rotated;
using test::shifted;
using testing::AllOf;
using testing::HasSubstr;

TEST(Q8Mesh, MeasuresARectangle) {
  const Q8Mesh mesh = rectangle_arrays(6, 2, 60.0, 20.0).build();
  EXPECT_EQ(mesh.element_count(), 12);
  EXPECT_EQ(mesh.node_count(), 13 * 5 - 12);
  EXPECT_DOUBLE_EQ(mesh.size(), 60.0);
  EXPECT_EQ(mesh.lower(), Point2(-30.0, -10.0));
  EXPECT_EQ(mesh.upper(), Point2(30.0, 10.0));
  EXPECT_NEAR(mesh.area(), 1200.0, 1e-12 * 1200.0);
  EXPECT_EQ(mesh.piece_count(), 1);
  EXPECT_EQ(mesh.reoriented_count(), 0);
}

// A parabola through the ends and the middle of an arc of angle φ bounds r²φ⁵/960 less than the
// arc, so that a circle of such edges misses the share φ⁴/480 of its area, but for terms of φ⁶
TEST(Q8Mesh, MeasuresTheAreaOfCurvedElements) {
  const double arc = 2.0 * std::numbers::pi / 64;
  const double exact = std::numbers::pi * (50.0 * 50.0 - 20.0 * 20.0);
  EXPECT_NEAR(ring_arrays(20.0, 50.0, 64, 3).build().area(),
              exact * (1.0 - std::pow(arc, 4) / 480.0), exact * std::pow(arc, 6));
}

TEST(Q8Mesh, RefusesAMeshWithoutElements) {
  EXPECT_THAT(error_of({Points2(2, 0), Connectivity(8, 0)}), HasSubstr("elements = 0"));
  EXPECT_THAT(error_of({rectangle_arrays(1, 1, 1.0, 1.0).nodes, Connectivity(8, 0)}),
              HasSubstr("elements = 0"));
}

TEST(Q8Mesh, RefusesCoordinatesThatAreNotFinite) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), -1e300}) {
    MeshArrays arrays = rectangle_arrays(2, 1, 2.0, 1.0);
    arrays.nodes(1, 4) = bad;
    EXPECT_THAT(error_of(arrays),
                AllOf(HasSubstr("nodes with unusable coordinates = 1"), HasSubstr("node 5 at")));
  }
}

TEST(Q8Mesh, RefusesIndicesOutOfRange) {
  for (const Index bad : {Index{-1}, Index{13}, std::numeric_limits<Index>::max() - 1}) {
    MeshArrays arrays = rectangle_arrays(2, 1, 2.0, 1.0);
    arrays.elements(3, 1) = bad;
    EXPECT_THAT(error_of(arrays), AllOf(HasSubstr("elements with a node out of range = 1"),
                                        HasSubstr("element 2 has node " + std::to_string(bad + 1)),
                                        HasSubstr("1 to 13")));
  }
}

TEST(Q8Mesh, RefusesARepeatedNodeWithinAnElement) {
  MeshArrays arrays = rectangle_arrays(2, 1, 2.0, 1.0);
  arrays.elements(3, 1) = arrays.elements(2, 1);
  EXPECT_THAT(error_of(arrays), AllOf(HasSubstr("elements with a repeated node = 1"),
                                      HasSubstr("element 2 has node")));
}

TEST(Q8Mesh, RefusesUnusedNodes) {
  MeshArrays arrays = rectangle_arrays(2, 1, 2.0, 1.0);
  arrays.nodes.conservativeResize(2, 14);
  arrays.nodes.col(13) << 7.0, 8.0;
  EXPECT_THAT(error_of(arrays),
              AllOf(HasSubstr("unused nodes = 1"), HasSubstr("node 14 at (7, 8) m")));
}

TEST(Q8Mesh, RefusesAMeshWithoutExtent) {
  const MeshArrays dot =
      mapped(rectangle_arrays(1, 1, 1.0, 1.0), [](const Point2& p) { return Point2(1e-8 * p); });
  EXPECT_THAT(error_of(dot), HasSubstr("size = 1e-08 m"));
}

TEST(Q8Mesh, NamesTenCulpritsAndCountsTheOthers) {
  MeshArrays arrays = rectangle_arrays(4, 4, 1.0, 1.0);
  arrays.nodes.conservativeResize(2, arrays.nodes.cols() + 13);
  arrays.nodes.rightCols(13).setConstant(3.0);
  const std::string message = error_of(arrays);
  EXPECT_THAT(message, AllOf(HasSubstr("unused nodes = 13"), HasSubstr("and 3 more")));
  std::size_t named = 0;
  for (std::size_t at = message.find("node "); at != std::string::npos;
       at = message.find("node ", at + 1))
    ++named;
  EXPECT_EQ(named, 11u);  // ten, and "every node must belong…"
}

TEST(Q8Mesh, TurnsClockwiseElements) {
  const MeshArrays arrays = mapped(rectangle_arrays(4, 3, 40.0, 30.0), bent);
  MeshArrays mixed = arrays;
  for (const Index e : {0, 5, 11}) {
    const Eigen::Matrix<Index, 8, 1> old = arrays.elements.col(e);
    mixed.elements.col(e) << old[0], old[3], old[2], old[1], old[7], old[6], old[5], old[4];
  }
  const Q8Mesh plain = arrays.build(), turned = mixed.build();
  const Index expected = plain.reoriented_count() == 0 ? 3 : 9;  // `bent` mirrors the plane
  EXPECT_EQ(turned.reoriented_count(), expected);
  EXPECT_EQ(turned.elements(), plain.elements());
  EXPECT_EQ(turned.area(), plain.area());
}

TEST(Q8Mesh, TurnsAMirroredMeshAsAWhole) {
  const MeshArrays arrays = mapped(rectangle_arrays(3, 2, 3.0, 2.0),
                                   [](const Point2& p) { return Point2(-p.x(), p.y()); });
  const Q8Mesh mesh = arrays.build();
  EXPECT_EQ(mesh.reoriented_count(), 6);
  EXPECT_NEAR(mesh.area(), 6.0, 1e-13);
}

TEST(Q8Mesh, RefusesABowTie) {
  MeshArrays arrays = rectangle_arrays(1, 1, 2.0, 2.0);
  std::swap(arrays.elements(1, 0), arrays.elements(2, 0));
  EXPECT_THAT(error_of(arrays), AllOf(HasSubstr("degenerate or folded elements = 1"),
                                      HasSubstr("element 1 at"), HasSubstr("det J = ")));
}

TEST(Q8Mesh, RefusesACollinearElement) {
  const MeshArrays arrays = mapped(rectangle_arrays(3, 1, 3.0, 1.0),
                                   [](const Point2& p) { return Point2(p.x(), 0.3 * p.x()); });
  EXPECT_THAT(error_of(arrays), HasSubstr("degenerate or folded elements = 3"));
}

TEST(Q8Mesh, RefusesAMidSideNodeFarOffItsEdge) {
  MeshArrays arrays = rectangle_arrays(1, 1, 2.0, 2.0);
  arrays.nodes(1, arrays.elements(4, 0)) = 1.5;
  EXPECT_THAT(error_of(arrays), HasSubstr("degenerate or folded elements = 1"));
}

TEST(Q8Mesh, RefusesSwappedMidSideNodes) {
  MeshArrays arrays = rectangle_arrays(1, 1, 2.0, 2.0);
  std::swap(arrays.elements(4, 0), arrays.elements(6, 0));
  EXPECT_THAT(error_of(arrays), HasSubstr("degenerate or folded elements = 1"));
}

TEST(Q8Mesh, AcceptsElementsOfAspectRatioOneThousand) {
  EXPECT_EQ(error_of(mapped(rectangle_arrays(3, 3, 300.0, 0.3), rotated)), "");
}

TEST(Q8Mesh, AcceptsOneElement) {
  EXPECT_EQ(rectangle_arrays(1, 1, 7.0, 3.0).build().element_count(), 1);
}

TEST(Q8Mesh, AcceptsFloatsOneHundredKilometresApart) {
  const MeshArrays plate = rectangle_arrays(50, 10, 10.0, 2.0);
  const Q8Mesh mesh = joined(plate, shifted(plate, 1e5, 1e5)).build();
  EXPECT_EQ(mesh.piece_count(), 2);
  EXPECT_NEAR(mesh.area(), 40.0, 1e-8);  // coordinates of 1e5 m carry 1.5e-11 m
}

TEST(Q8Mesh, AcceptsAMeshFarFromTheOrigin) {
  EXPECT_EQ(error_of(shifted(ring_arrays(20.0, 30.0, 24, 2), 5e5, 6e6)), "");
}

TEST(Q8Mesh, RefusesAMeshTooFarFromTheOriginForItsDigits) {
  EXPECT_EQ(error_of(shifted(rectangle_arrays(2, 2, 64.0, 64.0), 6e8, 0.0)), "");
  EXPECT_THAT(error_of(shifted(rectangle_arrays(2, 2, 32.0, 32.0), 6e8, 0.0)),
              HasSubstr("shift the mesh to the origin"));
}

TEST(Q8Mesh, NumbersPiecesByTheirFirstElement) {
  const MeshArrays plate = rectangle_arrays(2, 1, 2.0, 1.0);
  MeshArrays arrays = joined(joined(shifted(plate, 9.0, 0.0), plate), shifted(plate, -9.0, 0.0));
  arrays.elements.col(1).swap(arrays.elements.col(3));
  const Q8Mesh mesh = arrays.build();
  EXPECT_EQ(mesh.piece_count(), 3);
  EXPECT_EQ(mesh.element_piece(), (std::vector<int>{0, 1, 1, 0, 2, 2}));
  for (Index e = 0; e < mesh.element_count(); ++e)
    for (int a = 0; a < 8; ++a)
      EXPECT_EQ(mesh.node_piece()[mesh.elements()(a, e)], mesh.element_piece()[e]);
}

TEST(Q8Mesh, TreatsNegativeZeroAsZero) {
  MeshArrays arrays = rectangle_arrays(2, 2, 2.0, 2.0);
  for (double& x : arrays.nodes.reshaped())
    if (x == 0.0) x = -0.0;
  const Q8Mesh mesh = arrays.build();
  for (const double x : mesh.nodes().reshaped()) EXPECT_FALSE(x == 0.0 && std::signbit(x));
}

}  // namespace
}  // namespace floe::mesh
