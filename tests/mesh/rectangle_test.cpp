#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/error.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <set>
#include <utility>

namespace floe::mesh {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Rectangle, HasTheNodeCountOfItsLattice) {
  for (const auto& [nx, ny] : {std::pair{1, 1}, {5, 1}, {1, 4}, {7, 3}, {50, 10}}) {
    const Q8Mesh mesh = make_rectangle({.length = 300.0, .width = 60.0, .nx = nx, .ny = ny});
    EXPECT_EQ(mesh.node_count(), (2 * nx + 1) * (2 * ny + 1) - nx * ny);
    EXPECT_EQ(mesh.element_count(), nx * ny);
    EXPECT_EQ(mesh.piece_count(), 1);
    EXPECT_EQ(mesh.reoriented_count(), 0);
    EXPECT_NEAR(mesh.area(), 18000.0, 1e-12 * 18000.0);
  }
}

// The paper's mesh of 50 × 10 elements has 1621 nodes
TEST(Rectangle, MakesThePapersMesh) {
  EXPECT_EQ(make_rectangle({.length = 300.0, .width = 60.0, .nx = 50, .ny = 10}).node_count(),
            1621);
}

TEST(Rectangle, NumbersNodesRowByRowFromTheLowerLeft) {
  const Q8Mesh mesh = make_rectangle({.length = 4.0, .width = 3.0, .nx = 4, .ny = 3});
  for (Index n = 1; n < mesh.node_count(); ++n) {
    const Point2 before = mesh.nodes().col(n - 1), here = mesh.nodes().col(n);
    EXPECT_TRUE(here.y() > before.y() || (here.y() == before.y() && here.x() > before.x())) << n;
  }
}

TEST(Rectangle, PutsMidSideNodesHalfwayAndElementsInRows) {
  const Q8Mesh mesh =
      make_rectangle({.length = 40.0, .width = 30.0, .nx = 4, .ny = 3, .grading = 5.0});
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Eigen::Matrix<double, 2, 8> points = mesh.element_nodes(e);
    for (int side = 0; side < 4; ++side)
      EXPECT_EQ(points.col(4 + side), 0.5 * (points.col(side) + points.col((side + 1) % 4)));
    if (e % 4 > 0) {
      EXPECT_EQ(mesh.elements()(0, e), mesh.elements()(1, e - 1));
    }
    if (e >= 4) {
      EXPECT_EQ(mesh.elements()(0, e), mesh.elements()(3, e - 4));
    }
  }
}

TEST(Rectangle, IsSymmetricAboutTheOriginToTheLastBit) {
  for (const double grading : {1.0, 1.7, 20.0, 100.0})
    for (const auto& [nx, ny] : {std::pair{7, 4}, {50, 11}, {101, 33}}) {
      const Q8Mesh mesh =
          make_rectangle({.length = 300.1, .width = 60.7, .nx = nx, .ny = ny, .grading = grading});
      std::set<std::pair<double, double>> places;
      for (const auto& node : mesh.nodes().colwise()) places.emplace(node.x(), node.y());
      for (const auto& [x, y] : places) {
        EXPECT_TRUE(places.count({-x, y})) << grading << " " << x;
        EXPECT_TRUE(places.count({x, -y})) << grading << " " << y;
      }
      EXPECT_EQ(mesh.upper(), Point2(0.5 * 300.1, 0.5 * 60.7));
      EXPECT_EQ(mesh.lower(), -mesh.upper());
    }
}

TEST(Rectangle, HasEqualElementsWithoutGrading) {
  const Q8Mesh mesh = make_rectangle({.length = 3.0, .width = 0.7, .nx = 30, .ny = 7});
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Eigen::Matrix<double, 2, 8> points = mesh.element_nodes(e);
    EXPECT_NEAR(points(0, 1) - points(0, 0), 0.1, 4e-16 * 3.0);
    EXPECT_NEAR(points(1, 3) - points(1, 0), 0.1, 4e-16 * 0.7);
  }
}

TEST(Rectangle, GradesGeometricallyTowardsTheSides) {
  const double grading = 16.0;
  const Q8Mesh mesh =
      make_rectangle({.length = 10.0, .width = 10.0, .nx = 9, .ny = 9, .grading = grading});
  const auto edge = [&](Index e) {
    const Eigen::Matrix<double, 2, 8> points = mesh.element_nodes(e);
    return points(0, 1) - points(0, 0);
  };
  EXPECT_NEAR(edge(4) / edge(0), grading, 1e-12 * grading);
  for (Index e = 0; e < 4; ++e) EXPECT_NEAR(edge(e + 1) / edge(e), 2.0, 1e-12);
}

TEST(Rectangle, RefusesBadSizesAndCounts) {
  const RectangleOptions good{.length = 3.0, .width = 2.0, .nx = 2, .ny = 2};
  EXPECT_NO_THROW(make_rectangle(good));
  for (const double bad : {0.0, -1.0, kNan, std::numeric_limits<double>::infinity()}) {
    RectangleOptions options = good;
    options.length = bad;
    EXPECT_THROW(make_rectangle(options), InputError) << bad;
    options = good;
    options.width = bad;
    EXPECT_THROW(make_rectangle(options), InputError) << bad;
  }
  for (const int bad : {0, -3}) {
    RectangleOptions options = good;
    options.nx = bad;
    EXPECT_THROW(make_rectangle(options), InputError);
    options = good;
    options.ny = bad;
    EXPECT_THROW(make_rectangle(options), InputError);
  }
  for (const double bad : {0.5, 101.0, kNan}) {
    RectangleOptions options = good;
    options.grading = bad;
    EXPECT_THROW(make_rectangle(options), InputError) << bad;
  }
}

TEST(Rectangle, RefusesMoreElementsThanCanBeNumbered) {
  EXPECT_THROW(make_rectangle({.length = 1.0, .width = 1.0, .nx = 2000000000, .ny = 2000000000}),
               InputError);
}

}  // namespace
}  // namespace floe::mesh
