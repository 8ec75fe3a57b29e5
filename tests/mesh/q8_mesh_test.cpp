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

using test::joined;
using test::mapped;
using test::MeshArrays;
using test::rectangle_arrays;
using test::ring_arrays;
using test::shifted;
using testing::AllOf;
using testing::HasSubstr;

// The message of the MeshError that the arrays give; "" if they are accepted
std::string error_of(const MeshArrays& arrays) {
  try {
    arrays.build();
  } catch (const MeshError& error) {
    return error.what();
  }
  return "";
}

// The point (r, φ) of the plane for (x, y) = (φ, r)
Point2 bent(const Point2& p) {
  const double radius = 100.0 + p.y();
  return {radius * std::sin(p.x() / 100.0), radius * std::cos(p.x() / 100.0)};
}

Point2 rotated(const Point2& p) { return {0.8 * p.x() - 0.6 * p.y(), 0.6 * p.x() + 0.8 * p.y()}; }

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

TEST(Q8Mesh, RefusesUnmergedNodes) {
  const MeshArrays left = rectangle_arrays(2, 2, 2.0, 2.0);
  const std::string message = error_of(joined(left, shifted(left, 2.0 + 1e-7, 0.0)));
  EXPECT_THAT(message, AllOf(HasSubstr("coincident nodes = 5"), HasSubstr("at (1, -1) m")));
}

// Pairs on both sides of a cell boundary of the search, in all directions, must be seen
TEST(Q8Mesh, FindsCoincidentNodesWhereverTheyLie) {
  for (int i = 0; i < 32; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 32;
    MeshArrays arrays = rectangle_arrays(2, 2, 2.0, 2.0);
    const MeshArrays single = rectangle_arrays(1, 1, 0.1, 0.1);
    const Point2 shift(1.05 + 1.9e-6 * std::cos(angle), 1.05 + 1.9e-6 * std::sin(angle));
    EXPECT_THAT(error_of(joined(arrays, shifted(single, shift.x(), shift.y()))),
                HasSubstr("coincident nodes = 1"))
        << angle;
  }
}

TEST(Q8Mesh, RefusesDuplicateElements) {
  MeshArrays arrays = rectangle_arrays(3, 1, 3.0, 1.0);
  arrays.elements.conservativeResize(8, 4);
  arrays.elements.col(3) << arrays.elements(1, 1), arrays.elements(2, 1), arrays.elements(3, 1),
      arrays.elements(0, 1), arrays.elements(5, 1), arrays.elements(6, 1), arrays.elements(7, 1),
      arrays.elements(4, 1);
  EXPECT_THAT(error_of(arrays),
              AllOf(HasSubstr("duplicate elements = 1"), HasSubstr("elements 2 and 4")));
}

TEST(Q8Mesh, RefusesAnEdgeOfThreeElements) {
  MeshArrays arrays =
      joined(rectangle_arrays(2, 1, 2.0, 1.0), shifted(rectangle_arrays(1, 1, 1.0, 1.0), 0.5, 5.0));
  // The third element takes the right-hand edge of the first as its left-hand one
  const Eigen::Matrix<Index, 8, 1> first = arrays.elements.col(0);
  Eigen::Matrix<Index, 8, 1> third = arrays.elements.col(2);
  third[0] = first[1];
  third[3] = first[2];
  third[7] = first[5];
  MeshArrays bad = arrays;
  bad.elements.col(2) = third;
  for (const int corner : {1, 2, 4, 5, 6})
    bad.nodes(1, third[corner]) -= 4.7;  // an element of its own, on top of the second
  std::vector<Index> number(bad.nodes.cols(), -1);
  Points2 nodes(2, bad.nodes.cols());
  Index count = 0;
  for (Index& n : bad.elements.reshaped()) {
    if (number[n] < 0) {
      nodes.col(count) = bad.nodes.col(n);
      number[n] = count++;
    }
    n = number[n];
  }
  bad.nodes = nodes.leftCols(count);
  EXPECT_THAT(error_of(bad), HasSubstr("edges of more than two elements = 1"));
}

// Two elements that share their lower edge and lie on the same side of it
TEST(Q8Mesh, RefusesElementsOnTheSameSideOfAnEdge) {
  MeshArrays arrays = rectangle_arrays(1, 1, 2.0, 2.0);
  arrays.nodes.conservativeResize(2, 13);
  arrays.nodes.rightCols(5) << -1.0, 1.0, 1.0, 0.0, -1.0,  //
      5.0, 5.0, 2.5, 5.0, 2.5;
  arrays.elements.conservativeResize(8, 2);
  arrays.elements.col(1) << arrays.elements(0, 0), arrays.elements(1, 0), 9, 8,
      arrays.elements(4, 0), 10, 11, 12;
  EXPECT_THAT(error_of(arrays), HasSubstr("edges with overlapping elements = 1"));
}

TEST(Q8Mesh, RefusesAnEdgeWithTwoMidSideNodes) {
  MeshArrays arrays = rectangle_arrays(2, 1, 2.0, 1.0);
  const Index middle = arrays.elements(5, 0);
  ASSERT_EQ(middle, arrays.elements(7, 1));
  arrays.nodes.conservativeResize(2, 14);
  arrays.nodes.col(13) = arrays.nodes.col(middle) + Point2(0.05, 0.0);
  arrays.elements(7, 1) = 13;
  EXPECT_THAT(error_of(arrays), HasSubstr("edges with two mid-side nodes = 1"));
}

// One element beside two of half its height, with nodes of their own or the mid-side node shared
TEST(Q8Mesh, RefusesTJunctions) {
  MeshArrays apart = joined(shifted(rectangle_arrays(1, 1, 2.0, 2.0), -1.0, 0.0),
                            shifted(rectangle_arrays(1, 3, 1.0, 1.5), 0.5, 0.1));
  EXPECT_THAT(error_of(apart), AllOf(HasSubstr("hanging nodes = "), HasSubstr("element 1")));

  MeshArrays shared = joined(shifted(rectangle_arrays(1, 1, 2.0, 2.0), -1.0, 0.0),
                             shifted(rectangle_arrays(1, 2, 1.0, 2.0), 0.5, 0.0));
  // Merge the nodes that coincide
  std::vector<Index> number(shared.nodes.cols());
  Index count = 0;
  for (Index n = 0; n < shared.nodes.cols(); ++n) {
    number[n] = count;
    for (Index m = 0; m < n; ++m)
      if ((shared.nodes.col(m) - shared.nodes.col(n)).norm() < 1e-9) number[n] = number[m];
    if (number[n] != count) continue;
    shared.nodes.col(count++) = shared.nodes.col(n);
  }
  shared.nodes.conservativeResize(2, count);
  for (Index& n : shared.elements.reshaped()) n = number[n];
  EXPECT_THAT(error_of(shared), HasSubstr("hanging nodes = 1"));
}

TEST(Q8Mesh, RefusesTJunctionsOnCurvedEdges) {
  // The map is quadratic in x, so that both rims lie on one parabola
  const MeshArrays flat = joined(rectangle_arrays(1, 1, 2.0, 2.0),
                                 shifted(rectangle_arrays(3, 1, 1.9, 1.0), 0.02, -1.5));
  const MeshArrays curved =
      mapped(flat, [](const Point2& p) { return Point2(p.x(), p.y() - 0.2 * p.x() * p.x()); });
  EXPECT_THAT(error_of(curved), HasSubstr("hanging nodes = 8"));
}

TEST(Q8Mesh, RefusesPiecesThatCross) {
  // A plus sign: no node of one strip lies within the other's
  const MeshArrays strip = rectangle_arrays(1, 1, 100.0, 1.0);
  const MeshArrays cross =
      mapped(strip, [](const Point2& p) { return Point2(p.y() + 20.0, p.x() + 0.3); });
  EXPECT_THAT(error_of(joined(strip, cross)),
              AllOf(HasSubstr("overlapping elements = "), HasSubstr("elements 1 and 2")));
}

TEST(Q8Mesh, RefusesPiecesThatCrossAtASmallAngle) {
  const MeshArrays strip = rectangle_arrays(4, 1, 100.0, 0.5);
  const MeshArrays other = mapped(strip, [](const Point2& p) {
    return Point2(p.x() - 0.02 * p.y() + 3.3, 0.02 * p.x() + p.y() + 0.013);
  });
  EXPECT_THAT(error_of(joined(strip, other)), HasSubstr("overlapping elements = "));
}

TEST(Q8Mesh, RefusesPiecesThatOverlapAtACorner) {
  const MeshArrays plate = rectangle_arrays(5, 5, 10.0, 10.0);
  EXPECT_THAT(error_of(joined(plate, shifted(plate, 9.7, 9.6))),
              HasSubstr("overlapping elements = "));
}

TEST(Q8Mesh, RefusesAPieceThatLiesOnAnother) {
  const MeshArrays plate = rectangle_arrays(5, 5, 10.0, 10.0);
  const MeshArrays small = shifted(rectangle_arrays(2, 2, 0.3, 0.3), 0.37, 0.41);
  EXPECT_THAT(error_of(joined(plate, small)), HasSubstr("none may lie on another"));
  EXPECT_THAT(error_of(joined(small, plate)), HasSubstr("none may lie on another"));
  // The same within a single curved element
  const MeshArrays curved = mapped(rectangle_arrays(1, 1, 60.0, 40.0), bent);
  const MeshArrays inside = shifted(rectangle_arrays(1, 1, 0.3, 0.3), 5.0, 118.0);
  EXPECT_THAT(error_of(joined(curved, inside)), HasSubstr("none may lie on another"));
}

// A ring wound twice: every element and every edge is right by itself
TEST(Q8Mesh, RefusesASheetThatLiesOnItself) {
  const MeshArrays spiral = mapped(rectangle_arrays(24, 1, 24.0, 1.0), [](const Point2& p) {
    const double angle = -(p.x() + 12.0) * 4.0 * std::numbers::pi / 24.0 * 0.9;
    const double radius = 10.0 + 4.0 * p.y() - 0.1 * angle;
    return Point2(radius * std::cos(angle), radius * std::sin(angle));
  });
  EXPECT_THAT(error_of(spiral), HasSubstr("overlapping elements = "));
}

// Eight corners of 90 degrees around one node: a fan of two full turns
TEST(Q8Mesh, RefusesAFanOfTwoTurnsAroundANode) {
  const double step = std::numbers::pi / 2.0;
  Points2 nodes(2, 1 + 4 * 8);
  nodes.col(0).setZero();
  Connectivity elements(8, 8);
  const auto spoke = [](int i) { return 1 + 4 * ((i + 8) % 8); };
  for (int i = 0; i < 8; ++i) {
    const Point2 here(std::cos(i * step), std::sin(i * step));
    const Point2 next(std::cos((i + 1) * step), std::sin((i + 1) * step));
    const double stretch = 1.0 + 0.1 * i;  // no two nodes of the two turns at one place
    const double stretch_next = 1.0 + 0.1 * ((i + 1) % 8);
    const Point2 a = stretch * here, b = stretch_next * next;
    nodes.col(spoke(i)) = a;
    nodes.col(spoke(i) + 1) = 0.5 * a;
    nodes.col(spoke(i) + 2) = a + b;
    nodes.col(spoke(i) + 3) = a + 0.5 * b;
    elements.col(i) << 0, spoke(i), spoke(i) + 2, spoke(i + 1), spoke(i) + 1, spoke(i) + 3, -1,
        spoke(i + 1) + 1;
  }
  // The edge from the far corner to the next spoke has a middle of its own
  Points2 all(2, 41);
  all << nodes, Points2::Zero(2, 8);
  for (int i = 0; i < 8; ++i) {
    elements(6, i) = 33 + i;
    all.col(33 + i) = 0.5 * (all.col(elements(2, i)) + all.col(elements(3, i)));
  }
  EXPECT_THAT(error_of({all, elements}),
              AllOf(HasSubstr("nodes with overlapping elements = 1"), HasSubstr("720 degrees")));
}

TEST(Q8Mesh, AcceptsPiecesOneMillimetreApart) {
  const MeshArrays plate = rectangle_arrays(10, 4, 150.0, 60.0);
  const MeshArrays both = joined(plate, shifted(plate, 150.001, 0.0));
  const Q8Mesh mesh = both.build();
  EXPECT_EQ(mesh.piece_count(), 2);
  // The same on a slope, and for other divisions on the two sides of the gap
  EXPECT_EQ(error_of(mapped(both, rotated)), "");
  const MeshArrays finer = shifted(rectangle_arrays(11, 7, 150.0, 60.0), 150.001, 0.0);
  EXPECT_EQ(error_of(mapped(joined(plate, finer), rotated)), "");
}

TEST(Q8Mesh, AcceptsConcentricRingsOneMillimetreApart) {
  const MeshArrays outer = ring_arrays(30.001, 40.0, 48, 1);
  const MeshArrays inner = ring_arrays(20.0, 30.0, 48, 1);
  EXPECT_EQ(joined(inner, outer).build().piece_count(), 2);
}

// Parabolas of other divisions cross: a rim of 16 bulges 30·(2π/16)^4/384 = 1.9 mm or less from the
// circle, of 48 less; 5 mm keeps them apart
TEST(Q8Mesh, AcceptsConcentricRingsOfOtherDivisions) {
  const MeshArrays outer = ring_arrays(30.005, 40.0, 48, 1);
  const MeshArrays inner = ring_arrays(20.0, 30.0, 16, 1);
  EXPECT_EQ(error_of(joined(inner, outer)), "");
}

TEST(Q8Mesh, AcceptsARingInTheHoleOfAnother) {
  const MeshArrays outer = ring_arrays(30.0, 40.0, 24, 2);
  const MeshArrays disc = rectangle_arrays(2, 2, 10.0, 10.0);
  const Q8Mesh mesh = joined(outer, disc).build();
  EXPECT_EQ(mesh.piece_count(), 2);
}

TEST(Q8Mesh, AcceptsStronglyGradedMeshes) {
  for (const double grading : {1.0, 20.0, 100.0}) {
    const Q8Mesh mesh =
        make_rectangle({.length = 300.0, .width = 60.0, .nx = 40, .ny = 20, .grading = grading});
    EXPECT_EQ(error_of(mapped({mesh.nodes(), mesh.elements()}, bent)), "") << grading;
  }
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

TEST(Q8Mesh, RefusesPiecesJoinedAtASingleNode) {
  MeshArrays arrays =
      joined(rectangle_arrays(1, 1, 1.0, 1.0), shifted(rectangle_arrays(1, 1, 1.0, 1.0), 1.0, 1.0));
  // The second element's lower left corner becomes the first one's upper right
  const Index kept = arrays.elements(2, 0), gone = arrays.elements(0, 1);
  arrays.elements(0, 1) = kept;
  for (Index& n : arrays.elements.reshaped())
    if (n > gone) --n;
  arrays.nodes.block(0, gone, 2, arrays.nodes.cols() - gone - 1) =
      arrays.nodes.rightCols(arrays.nodes.cols() - gone - 1).eval();
  arrays.nodes.conservativeResize(2, arrays.nodes.cols() - 1);
  EXPECT_THAT(error_of(arrays),
              AllOf(HasSubstr("joints at a single node = 1"), HasSubstr("at (0.5, 0.5) m")));
}

TEST(Q8Mesh, TreatsNegativeZeroAsZero) {
  MeshArrays arrays = rectangle_arrays(2, 2, 2.0, 2.0);
  for (double& x : arrays.nodes.reshaped())
    if (x == 0.0) x = -0.0;
  const Q8Mesh mesh = arrays.build();
  for (const double x : mesh.nodes().reshaped()) EXPECT_FALSE(x == 0.0 && std::signbit(x));
}

// A search that compared all pairs of these 120,000 boundary nodes would take minutes
TEST(Q8Mesh, ChecksFifteenThousandPiecesQuickly) {
  const MeshArrays single = rectangle_arrays(1, 1, 0.9, 0.9);
  MeshArrays arrays{Points2(2, 8 * 15000), Connectivity(8, 15000)};
  for (Index e = 0; e < 15000; ++e) {
    const Point2 place(static_cast<double>(e % 150), static_cast<double>(e / 150));
    arrays.nodes.middleCols<8>(8 * e) = single.nodes.colwise() + place;
    arrays.elements.col(e) = single.elements.array() + 8 * e;
  }
  EXPECT_EQ(arrays.build().piece_count(), 15000);
}

}  // namespace
}  // namespace floe::mesh
