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

TEST(Q8MeshConformity, RefusesUnmergedNodes) {
  const MeshArrays left = rectangle_arrays(2, 2, 2.0, 2.0);
  const std::string message = error_of(joined(left, shifted(left, 2.0 + 1e-7, 0.0)));
  EXPECT_THAT(message, AllOf(HasSubstr("coincident nodes = 5"), HasSubstr("at (1, -1) m")));
}

// Pairs on both sides of a cell boundary of the search, in all directions, must be seen: the pair
// is a little nearer than the tolerance, and the cells are shifted by parts of it
TEST(Q8MeshConformity, FindsCoincidentNodesWhereverTheyLie) {
  for (int i = 0; i < 32; ++i)
    for (int shift = 0; shift < 10; ++shift) {
      const double angle = 2.0 * std::numbers::pi * i / 32, edge = 1.0 + 1.7e-7 * shift;
      const MeshArrays arrays = rectangle_arrays(2, 2, 2.0 * edge, 2.0 * edge);
      const MeshArrays single = rectangle_arrays(1, 1, 0.1, 0.1);
      const double dx = edge + 0.05 + 1.9e-6 * std::cos(angle);
      const double dy = edge + 0.05 + 1.9e-6 * std::sin(angle);
      EXPECT_THAT(error_of(joined(arrays, shifted(single, dx, dy))),
                  HasSubstr("coincident nodes = 1"))
          << angle << " " << shift;
    }
}

TEST(Q8MeshConformity, RefusesDuplicateElements) {
  MeshArrays arrays = rectangle_arrays(3, 1, 3.0, 1.0);
  arrays.elements.conservativeResize(8, 4);
  arrays.elements.col(3) << arrays.elements(1, 1), arrays.elements(2, 1), arrays.elements(3, 1),
      arrays.elements(0, 1), arrays.elements(5, 1), arrays.elements(6, 1), arrays.elements(7, 1),
      arrays.elements(4, 1);
  EXPECT_THAT(error_of(arrays),
              AllOf(HasSubstr("duplicate elements = 1"), HasSubstr("elements 2 and 4")));
}

TEST(Q8MeshConformity, RefusesAnEdgeOfThreeElements) {
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
TEST(Q8MeshConformity, RefusesElementsOnTheSameSideOfAnEdge) {
  MeshArrays arrays = rectangle_arrays(1, 1, 2.0, 2.0);
  arrays.nodes.conservativeResize(2, 13);
  arrays.nodes.rightCols(5) << -1.0, 1.0, 1.0, 0.0, -1.0,  //
      5.0, 5.0, 2.5, 5.0, 2.5;
  arrays.elements.conservativeResize(8, 2);
  arrays.elements.col(1) << arrays.elements(0, 0), arrays.elements(1, 0), 9, 8,
      arrays.elements(4, 0), 10, 11, 12;
  EXPECT_THAT(error_of(arrays), HasSubstr("edges with overlapping elements = 1"));
}

TEST(Q8MeshConformity, RefusesAnEdgeWithTwoMidSideNodes) {
  MeshArrays arrays = rectangle_arrays(2, 1, 2.0, 1.0);
  const Index middle = arrays.elements(5, 0);
  ASSERT_EQ(middle, arrays.elements(7, 1));
  arrays.nodes.conservativeResize(2, 14);
  arrays.nodes.col(13) = arrays.nodes.col(middle) + Point2(0.05, 0.0);
  arrays.elements(7, 1) = 13;
  EXPECT_THAT(error_of(arrays), HasSubstr("edges with two mid-side nodes = 1"));
}

// One element beside two of half its height, with nodes of their own or the mid-side node shared
TEST(Q8MeshConformity, RefusesTJunctions) {
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

// Two elements that bulge towards each other and share the mid-side nodes where they meet
TEST(Q8MeshConformity, RefusesAMidSideNodeOfTwoEdges) {
  MeshArrays arrays =
      joined(rectangle_arrays(1, 1, 2.0, 2.0), shifted(rectangle_arrays(1, 1, 2.0, 2.0), 0.0, 2.4));
  const Index kept = arrays.elements(6, 0), gone = arrays.elements(4, 1);
  arrays.nodes(1, kept) = 1.2;
  arrays.elements(4, 1) = kept;
  for (Index& n : arrays.elements.reshaped())
    if (n == arrays.nodes.cols() - 1) n = gone;
  arrays.nodes.col(gone) = arrays.nodes.rightCols(1).eval();
  arrays.nodes.conservativeResize(2, arrays.nodes.cols() - 1);
  EXPECT_THAT(error_of(arrays), HasSubstr("hanging nodes = 1"));
}

TEST(Q8MeshConformity, RefusesTJunctionsOnCurvedEdges) {
  // The map is quadratic in x, so that both rims lie on one parabola
  const MeshArrays flat = joined(rectangle_arrays(1, 1, 2.0, 2.0),
                                 shifted(rectangle_arrays(3, 1, 1.9, 1.0), 0.02, -1.5));
  const MeshArrays curved =
      mapped(flat, [](const Point2& p) { return Point2(p.x(), p.y() - 0.2 * p.x() * p.x()); });
  EXPECT_THAT(error_of(curved), HasSubstr("hanging nodes = 8"));
}

TEST(Q8MeshConformity, RefusesPiecesThatCross) {
  // A plus sign: no node of one strip lies within the other's
  const MeshArrays strip = rectangle_arrays(1, 1, 100.0, 1.0);
  const MeshArrays cross =
      mapped(strip, [](const Point2& p) { return Point2(p.y() + 20.0, p.x() + 0.3); });
  EXPECT_THAT(error_of(joined(strip, cross)),
              AllOf(HasSubstr("overlapping elements = "), HasSubstr("elements 1 and 2")));
}

TEST(Q8MeshConformity, RefusesPiecesThatCrossAtASmallAngle) {
  const MeshArrays strip = rectangle_arrays(4, 1, 100.0, 0.5);
  const MeshArrays other = mapped(strip, [](const Point2& p) {
    return Point2(p.x() - 0.02 * p.y() + 3.3, 0.02 * p.x() + p.y() + 0.013);
  });
  EXPECT_THAT(error_of(joined(strip, other)), HasSubstr("overlapping elements = "));
}

TEST(Q8MeshConformity, RefusesPiecesThatOverlapAtACorner) {
  const MeshArrays plate = rectangle_arrays(5, 5, 10.0, 10.0);
  EXPECT_THAT(error_of(joined(plate, shifted(plate, 9.7, 9.6))),
              HasSubstr("overlapping elements = "));
}

TEST(Q8MeshConformity, RefusesAPieceThatLiesOnAnother) {
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
TEST(Q8MeshConformity, RefusesASheetThatLiesOnItself) {
  const MeshArrays spiral = mapped(rectangle_arrays(24, 1, 24.0, 1.0), [](const Point2& p) {
    const double angle = -(p.x() + 12.0) * 4.0 * std::numbers::pi / 24.0 * 0.9;
    const double radius = 10.0 + 4.0 * p.y() - 0.1 * angle;
    return Point2(radius * std::cos(angle), radius * std::sin(angle));
  });
  EXPECT_THAT(error_of(spiral), HasSubstr("overlapping elements = "));
}

// Quadrilaterals around the origin, one between any two neighbouring spokes. Node 0 is the origin,
// 1 + 2i the end of spoke i and 2 + 2i its middle.
MeshArrays fan(const std::vector<Point2>& spokes, bool closed) {
  const Index count = static_cast<Index>(spokes.size()), quads = closed ? count : count - 1;
  MeshArrays arrays{Points2::Zero(2, 1 + 2 * count + 3 * quads), Connectivity(8, quads)};
  for (Index i = 0; i < count; ++i) {
    arrays.nodes.col(1 + 2 * i) = spokes[i];
    arrays.nodes.col(2 + 2 * i) = 0.5 * spokes[i];
  }
  for (Index i = 0; i < quads; ++i) {
    const Index next = (i + 1) % count, own = 1 + 2 * count + 3 * i;
    arrays.nodes.col(own) = spokes[i] + spokes[next];
    arrays.nodes.col(own + 1) = spokes[i] + 0.5 * spokes[next];
    arrays.nodes.col(own + 2) = 0.5 * spokes[i] + spokes[next];
    arrays.elements.col(i) << 0, 1 + 2 * i, own, 1 + 2 * next, 2 + 2 * i, own + 1, own + 2,
        2 + 2 * next;
  }
  return arrays;
}

Point2 polar(double radius, double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// Spokes grow, so that no two nodes of the two turns lie at one place
TEST(Q8MeshConformity, RefusesAFanOfTwoTurnsAroundANode) {
  std::vector<Point2> spokes;
  for (int i = 0; i < 8; ++i) spokes.push_back(polar(1.0 + 0.1 * i, 90.0 * i));
  EXPECT_THAT(error_of(fan(spokes, true)),
              AllOf(HasSubstr("nodes with overlapping elements = 1"), HasSubstr("720 degrees")));
  spokes.resize(4);
  EXPECT_EQ(error_of(fan(spokes, true)), "");
}

// The two sides of a wedge of 20 degrees, bent so that they cross away from their common corner
TEST(Q8MeshConformity, RefusesEdgesThatCrossBeyondACommonNode) {
  MeshArrays arrays =
      fan({polar(2.0, 0.0), polar(2.0, 110.0), polar(2.0, 220.0), polar(2.0, 340.0)}, false);
  EXPECT_EQ(error_of(arrays), "");
  arrays.nodes.col(2) += Point2(0.0, -0.3);
  arrays.nodes.col(8) += Point2(-0.4, 0.1);
  EXPECT_THAT(error_of(arrays),
              AllOf(HasSubstr("overlapping elements = 1"), HasSubstr("elements 1 and 3")));
}

TEST(Q8MeshConformity, AcceptsPiecesOneMillimetreApart) {
  const MeshArrays plate = rectangle_arrays(10, 4, 150.0, 60.0);
  const MeshArrays both = joined(plate, shifted(plate, 150.001, 0.0));
  const Q8Mesh mesh = both.build();
  EXPECT_EQ(mesh.piece_count(), 2);
  // The same on a slope, and for other divisions on the two sides of the gap
  EXPECT_EQ(error_of(mapped(both, rotated)), "");
  const MeshArrays finer = shifted(rectangle_arrays(11, 7, 150.0, 60.0), 150.001, 0.0);
  EXPECT_EQ(error_of(mapped(joined(plate, finer), rotated)), "");
}

TEST(Q8MeshConformity, AcceptsConcentricRingsOneMillimetreApart) {
  const MeshArrays outer = ring_arrays(30.001, 40.0, 48, 1);
  const MeshArrays inner = ring_arrays(20.0, 30.0, 48, 1);
  EXPECT_EQ(joined(inner, outer).build().piece_count(), 2);
}

// Parabolas of other divisions cross: a rim of 16 bulges 30·(2π/16)^4/384 = 1.9 mm or less from the
// circle, of 48 less; 5 mm keeps them apart
TEST(Q8MeshConformity, AcceptsConcentricRingsOfOtherDivisions) {
  const MeshArrays outer = ring_arrays(30.005, 40.0, 48, 1);
  const MeshArrays inner = ring_arrays(20.0, 30.0, 16, 1);
  EXPECT_EQ(error_of(joined(inner, outer)), "");
}

TEST(Q8MeshConformity, AcceptsARingInTheHoleOfAnother) {
  const MeshArrays outer = ring_arrays(30.0, 40.0, 24, 2);
  const MeshArrays disc = rectangle_arrays(2, 2, 10.0, 10.0);
  const Q8Mesh mesh = joined(outer, disc).build();
  EXPECT_EQ(mesh.piece_count(), 2);
}

TEST(Q8MeshConformity, AcceptsStronglyGradedMeshes) {
  for (const double grading : {1.0, 20.0, 100.0}) {
    const Q8Mesh mesh =
        make_rectangle({.length = 300.0, .width = 60.0, .nx = 40, .ny = 20, .grading = grading});
    EXPECT_EQ(error_of(mapped({mesh.nodes(), mesh.elements()}, bent)), "") << grading;
  }
}

// Two elements of 1e-7 m and one of 5e8 m: the small ones are below what coordinates can tell
TEST(Q8MeshConformity, TakesElementsBelowTheResolutionOfTheMeshForPoints) {
  const MeshArrays small =
      mapped(rectangle_arrays(2, 1, 2.0, 1.0), [](const Point2& p) { return Point2(1e-7 * p); });
  const MeshArrays large = shifted(rectangle_arrays(1, 1, 5e8, 5e8), 5e8, 5e8);
  EXPECT_THAT(error_of(joined(small, large)), HasSubstr("coincident nodes"));
}

TEST(Q8MeshConformity, RefusesPiecesJoinedAtASingleNode) {
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

// A search that compared all pairs of these 120,000 boundary nodes would take minutes
TEST(Q8MeshConformity, ChecksFifteenThousandPiecesQuickly) {
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
