#include "mesh/inverse_map.hpp"

#include <floe/mesh/shape_functions.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace floe::mesh {
namespace {

bool is_folded(const ElementNodes& points) {
  for (double xi = -1.0; xi <= 1.0; xi += 0.125)
    for (double eta = -1.0; eta <= 1.0; eta += 0.125) {
      const Eigen::Matrix2d jacobian = q8_shape_gradient(xi, eta) * points.transpose();
      if (jacobian(0, 0) * jacobian(1, 1) - jacobian(0, 1) * jacobian(1, 0) < 0.02) return true;
    }
  return false;
}

// Elements whose nodes are moved by up to 0.9 of half an edge and that do not fold
std::vector<ElementNodes> wild_elements(int count) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<ElementNodes> elements;
  while (static_cast<int>(elements.size()) < count) {
    ElementNodes points = q8_parametric_nodes();
    const double reach = 0.9 * std::abs(unit(random));
    for (double& x : points.reshaped()) x += reach * unit(random);
    if (!is_folded(points)) elements.push_back(points);
  }
  return elements;
}

// Newton from the centre alone misses one such point in two thousand
TEST(InverseMap, FindsEveryPointOfWildElements) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const ElementNodes& points : wild_elements(3000))
    for (int i = 0; i < 20; ++i) {
      const Point2 place(unit(random), unit(random));
      const Point2 point = points * q8_shape(place.x(), place.y());
      const auto found = find_parametric(points, point);
      ASSERT_TRUE(found) << points << "\nat " << place.transpose();
      EXPECT_LE((points * q8_shape(found->x(), found->y()) - point).norm(), 1e-11);
    }
}

// Points a little outside each edge, along its outward normal; the edge turns away from them or
// towards them, but nowhere else is the element so near
TEST(InverseMap, FindsNothingOutside) {
  ElementNodes points = q8_parametric_nodes();
  points.col(4) << 0.1, -0.6;  // bent inwards
  points.col(6) << -0.1, 1.5;  // and outwards
  for (int side = 0; side < 4; ++side)
    for (double s = -0.9; s <= 0.9; s += 0.1) {
      const Point2 along(s, -1.0);
      const auto turned = [&](const Point2& p) {
        Point2 q = p;
        for (int i = 0; i < side; ++i) q = Point2(-q.y(), q.x());
        return q;
      };
      const Point2 place = turned(along), beyond = turned({s, -1.0 - 1e-5});
      EXPECT_TRUE(find_parametric(points, points * q8_shape(place.x(), place.y())));
      EXPECT_FALSE(find_parametric(points, points * q8_shape(beyond.x(), beyond.y())))
          << side << " " << s;
    }
}

}  // namespace
}  // namespace floe::mesh
