#include "tiny_meshes.hpp"

#include <floe/mesh/point_locator.hpp>
#include <floe/mesh/shape_functions.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace floe::mesh {
namespace {

using test::joined;
using test::mapped;
using test::rectangle_arrays;
using test::ring_arrays;
using test::shifted;

Point2 position(const Q8Mesh& mesh, const ElementPoint& place) {
  return mesh.element_nodes(place.element) * q8_shape(place.xi, place.eta);
}

// A mesh of strongly curved and skewed elements
Q8Mesh wavy_mesh() {
  return mapped(rectangle_arrays(7, 5, 70.0, 50.0),
                [](const Point2& p) {
                  return Point2(p.x() + 1.5 * std::sin(0.3 * p.y()) + 0.4 * p.y(),
                                p.y() + 1.5 * std::sin(0.3 * p.x()));
                })
      .build();
}

// Puts random parametric points back; rounding of coordinates up to 1e2 m, over edges of 10 m and
// det J down to a tenth of the mean, leaves 1e-13
TEST(PointLocator, PutsRandomPointsBack) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> parametric(-0.999, 0.999);
  for (const Q8Mesh& mesh :
       {wavy_mesh(), ring_arrays(10.0, 40.0, 12, 2).build(),
        make_rectangle({.length = 300.0, .width = 60.0, .nx = 24, .ny = 12, .grading = 100.0})}) {
    const PointLocator locator(mesh);
    for (int i = 0; i < 3000; ++i) {
      const ElementPoint place{i % mesh.element_count(), parametric(random), parametric(random)};
      const auto found = locator.locate(position(mesh, place));
      ASSERT_TRUE(found) << i;
      EXPECT_EQ(found->element, place.element);
      EXPECT_NEAR(found->xi, place.xi, 1e-10);
      EXPECT_NEAR(found->eta, place.eta, 1e-10);
      EXPECT_LE((position(mesh, *found) - position(mesh, place)).norm(), 1e-12 * mesh.size());
    }
  }
}

// The slow twin: which elements hold a point, from the winding of a fine polygon along the edges
bool inside_polygon(const Q8Mesh& mesh, Index element, const Point2& point) {
  constexpr int kSteps = 400;
  const Eigen::Matrix<double, 2, 8> nodes = mesh.element_nodes(element);
  double angle = 0.0;
  Point2 previous = nodes * q8_shape(-1.0, -1.0) - point;
  for (int i = 1; i <= 4 * kSteps; ++i) {
    const double s = 2.0 * (i % kSteps) / kSteps - 1.0;
    const int side = (i / kSteps) % 4;
    const double xi[] = {s, 1.0, -s, -1.0}, eta[] = {-1.0, s, 1.0, -s};
    const Point2 next = nodes * q8_shape(xi[side], eta[side]) - point;
    angle += std::atan2(previous.x() * next.y() - previous.y() * next.x(), previous.dot(next));
    previous = next;
  }
  return angle > 3.0;
}

TEST(twin_PointLocator, AgreesWithASearchOfAllElements) {
  const Q8Mesh mesh = wavy_mesh();
  const PointLocator locator(mesh);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const Point2 extent = 1.1 * (mesh.upper() - mesh.lower());
  const Point2 start = mesh.lower() - 0.05 * (mesh.upper() - mesh.lower());
  for (int i = 0; i < 400; ++i) {
    const Point2 point = start + Point2(unit(random) * extent.x(), unit(random) * extent.y());
    Index expected = -1;
    for (Index e = 0; e < mesh.element_count() && expected < 0; ++e)
      if (inside_polygon(mesh, e, point)) expected = e;
    const auto found = locator.locate(point);
    EXPECT_EQ(found ? found->element : -1, expected) << point.transpose();
  }
}

TEST(PointLocator, FindsEveryNode) {
  for (const Q8Mesh& mesh :
       {wavy_mesh(), shifted(ring_arrays(10.0, 40.0, 12, 2), 5e5, 6e6).build()}) {
    const PointLocator locator(mesh);
    for (Index n = 0; n < mesh.node_count(); ++n) {
      const auto found = locator.locate(mesh.nodes().col(n));
      ASSERT_TRUE(found) << n;
      EXPECT_LE((position(mesh, *found) - mesh.nodes().col(n)).norm(), 1e-8 * mesh.size());
      // The first element that has the node
      Index first = 0;
      while (!(mesh.elements().col(first).array() == n).any()) ++first;
      EXPECT_EQ(found->element, first) << n;
    }
  }
}

TEST(PointLocator, TakesTheFirstElementOfAnEdge) {
  const Q8Mesh mesh = rectangle_arrays(3, 3, 3.0, 3.0).build();
  const PointLocator locator(mesh);
  EXPECT_EQ(locator.locate({-0.5, 0.2})->element, 3);
  EXPECT_EQ(locator.locate({0.2, -0.5})->element, 1);
  EXPECT_EQ(locator.locate({0.5, 0.5})->element, 4);
  EXPECT_EQ(locator.locate({-1.5, -1.5})->element, 0);
  EXPECT_EQ(locator.locate({1.5, 1.5})->element, 8);
}

TEST(PointLocator, CountsEdgesToOneMillionthOfTheSize) {
  const Q8Mesh plate = rectangle_arrays(6, 2, 60.0, 20.0).build();
  const PointLocator locator(plate);
  const double reach = 1e-6 * 60.0;
  for (const Point2& direction : {Point2(1, 0), Point2(-1, 0), Point2(0, 1), Point2(0, -1)}) {
    const Point2 edge(30.0 * direction.x() + 7.0 * direction.y(),
                      10.0 * direction.y() + 3.0 * direction.x());
    const auto near = locator.locate(edge + 0.9 * reach * direction);
    ASSERT_TRUE(near);
    EXPECT_LE((position(plate, *near) - edge).norm(), 1e-13);
    EXPECT_FALSE(locator.locate(edge + 1.1 * reach * direction));
  }
  const auto corner = locator.locate(Point2(30.0, 10.0) + 0.6 * reach * Point2(1, 1));
  ASSERT_TRUE(corner);
  EXPECT_EQ(position(plate, *corner), Point2(30.0, 10.0));
  EXPECT_FALSE(locator.locate(Point2(30.0, 10.0) + 0.8 * reach * Point2(1, 1)));
}

TEST(PointLocator, CountsSkewedAndCurvedEdgesToOneMillionthOfTheSize) {
  // Sheared elements: the parametric lines meet the edge at 11 degrees
  const Q8Mesh sheared = mapped(rectangle_arrays(4, 4, 40.0, 40.0), [](const Point2& p) {
                           return Point2(p.x() + 5.0 * p.y(), p.y());
                         }).build();
  const PointLocator shear_locator(sheared);
  EXPECT_TRUE(shear_locator.locate({100.0, 20.0 + 0.9e-6 * sheared.size()}));
  EXPECT_FALSE(shear_locator.locate({100.0, 20.0 + 1.1e-6 * sheared.size()}));

  const Q8Mesh ring = ring_arrays(10.0, 40.0, 8, 1).build();
  const PointLocator ring_locator(ring);
  for (int i = 0; i < 8; ++i) {  // mid-side nodes lie on the circles
    const double angle = 2.0 * std::numbers::pi * (i + 0.5) / 8;
    const Point2 out(std::cos(angle), std::sin(angle));
    for (const double radius : {40.0, 10.0}) {
      const double away = radius > 20.0 ? 1e-6 * ring.size() : -1e-6 * ring.size();
      EXPECT_TRUE(ring_locator.locate((radius + 0.9 * away) * out)) << i;
      EXPECT_FALSE(ring_locator.locate((radius + 1.1 * away) * out)) << i;
    }
  }
}

TEST(PointLocator, FindsNothingInHolesGapsAndOutside) {
  const Q8Mesh mesh =
      joined(ring_arrays(10.0, 40.0, 16, 2), shifted(rectangle_arrays(4, 2, 40.0, 20.0), 61.0, 0.0))
          .build();
  const PointLocator locator(mesh);
  EXPECT_FALSE(locator.locate({0.0, 0.0}));
  EXPECT_FALSE(locator.locate({-7.0, 6.9}));
  EXPECT_FALSE(locator.locate({40.5, 0.0}));
  EXPECT_FALSE(locator.locate({0.0, 41.0}));
  EXPECT_FALSE(locator.locate({1e9, -1e9}));
  EXPECT_TRUE(locator.locate({41.0, 0.0}));
}

TEST(PointLocator, FindsNothingForPointsThatAreNotFinite) {
  const Q8Mesh mesh = test::tiny_plate();
  const PointLocator locator(mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(locator.locate({nan, 0.0}));
  EXPECT_FALSE(locator.locate({0.0, infinity}));
  EXPECT_FALSE(locator.locate({-infinity, nan}));
}

TEST(PointLocator, CanBeCopied) {
  const Q8Mesh mesh = test::tiny_plate();
  const PointLocator locator(mesh);
  const PointLocator copy = locator;
  EXPECT_EQ(copy.locate({29.0, 9.0})->element, locator.locate({29.0, 9.0})->element);
}

}  // namespace
}  // namespace floe::mesh
