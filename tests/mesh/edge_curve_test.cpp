#include "mesh/edge_curve.hpp"

#include "tiny_meshes.hpp"

#include <floe/mesh/shape_functions.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace floe::mesh {
namespace {

EdgeCurve line(const Point2& from, const Point2& to) { return {from, 0.5 * (from + to), to}; }

// y = height (1 - x²) for |x| <= 1
EdgeCurve arch(double height) { return {{-1.0, 0.0}, {0.0, 2.0 * height}, {1.0, 0.0}}; }

TEST(EdgeCurve, IsTheEdgeOfItsElement) {
  const ElementNodes points = test::ring_arrays(1.0, 3.0, 5, 1).build().element_nodes(2);
  for (int side = 0; side < 4; ++side)
    for (const double t : {0.0, 0.3, 0.5, 1.0}) {
      const Point2 place = edge_parametric(side, t);
      const Point2 expected = points * q8_shape(place.x(), place.y());
      EXPECT_LE((edge_curve(points, side).point(t) - expected).norm(), 2e-15) << side << " " << t;
    }
}

TEST(EdgeCurve, CutsOutItsParts) {
  const EdgeCurve curve{{0.0, 0.0}, {2.0, 3.0}, {5.0, -1.0}};
  const EdgeCurve part = curve.part(0.25, 0.75);
  for (const double t : {0.0, 0.4, 1.0})
    EXPECT_LE((part.point(t) - curve.point(0.25 + 0.5 * t)).norm(), 2e-15);
}

TEST(EdgeCurve, FindsTheNearestPointOfALine) {
  const NearestPoint inside = nearest_point(line({0, 0}, {10, 0}), {3.0, 4.0});
  EXPECT_NEAR(inside.t, 0.3, 1e-15);
  EXPECT_DOUBLE_EQ(inside.distance, 4.0);
  const NearestPoint beyond = nearest_point(line({0, 0}, {10, 0}), {13.0, 4.0});
  EXPECT_EQ(beyond.t, 1.0);
  EXPECT_DOUBLE_EQ(beyond.distance, 5.0);
}

// Against a fine sampling, which misses by the distance between samples, 2e-4, at most
TEST(EdgeCurve, FindsTheNearestPointOfAParabola) {
  for (const double height : {0.1, 0.5, 1.5})
    for (double x = -1.4; x <= 1.4; x += 0.2)
      for (double y = -1.0; y <= 2.0; y += 0.25) {
        const EdgeCurve curve = arch(height);
        double sampled = INFINITY;
        for (int i = 0; i <= 20000; ++i)
          sampled = std::min(sampled, (curve.point(i / 20000.0) - Point2(x, y)).norm());
        const NearestPoint nearest = nearest_point(curve, {x, y});
        EXPECT_LE(nearest.distance, sampled + 1e-15) << height << " " << x << " " << y;
        EXPECT_NEAR(nearest.distance, (curve.point(nearest.t) - Point2(x, y)).norm(), 1e-15);
        EXPECT_NEAR(nearest.distance, sampled, 2e-4);
      }
}

TEST(EdgeCurve, TellsCrossingCurvesFromSeparateOnes) {
  const double flatness = 1e-9;
  const EdgeCurve base = arch(0.3);
  EXPECT_TRUE(curves_meet(base, line({-1, 0.1}, {1, 0.1}), flatness));
  EXPECT_TRUE(curves_meet(base, line({0, -1}, {0, 1}), flatness));  // at t = 1/2 of both
  EXPECT_FALSE(curves_meet(base, line({-1, 0.31}, {1, 0.31}), flatness));
  EXPECT_FALSE(curves_meet(base, line({-1, -0.01}, {1, -0.01}), flatness));
  EXPECT_FALSE(curves_meet(line({0, 0}, {1, 0}), line({2, 0}, {3, 0}), flatness));
  EXPECT_FALSE(curves_meet(line({0, 0}, {1, 1}), line({0, 0.1}, {1, 1.1}), flatness));
}

TEST(EdgeCurve, TellsCurvesApartDownToSmallGaps) {
  for (const double gap : {1e-1, 1e-3, 1e-5, 1e-7}) {
    // The same arch, raised by the gap; and one that is steeper by it, so that they cross twice
    EdgeCurve raised = arch(0.3), steeper = arch(0.3 + gap);
    for (Point2* point : {&raised.start, &raised.control, &raised.end}) point->y() += gap;
    for (Point2* point : {&steeper.start, &steeper.control, &steeper.end}) point->y() -= 0.5 * gap;
    EXPECT_FALSE(curves_meet(arch(0.3), raised, 1e-9)) << gap;
    EXPECT_TRUE(curves_meet(arch(0.3), steeper, 1e-9)) << gap;
  }
}

TEST(EdgeCurve, EndsOnCurvesThatCoincide) { EXPECT_TRUE(curves_meet(arch(0.3), arch(0.3), 0.0)); }

}  // namespace
}  // namespace floe::mesh
