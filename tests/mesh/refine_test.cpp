#include "expect.hpp"
#include "tiny_meshes.hpp"

#include <floe/mesh/point_locator.hpp>
#include <floe/mesh/refine.hpp>

#include <gtest/gtest.h>

namespace floe::mesh {
namespace {

TEST(Refine, DividesEveryElementIntoFourOfTheSameSurface) {
  for (const Q8Mesh& mesh :
       {test::tiny_plate(), test::ring_arrays(10.0, 20.0, 12, 2).build(),
        test::joined(test::rectangle_arrays(3, 2, 9.0, 4.0),
                     test::shifted(test::rectangle_arrays(2, 2, 4.0, 4.0), 20.0, 3.0))
            .build()}) {
    const Q8Mesh fine = refine(mesh);
    EXPECT_EQ(fine.element_count(), 4 * mesh.element_count());
    EXPECT_EQ(fine.piece_count(), mesh.piece_count());
    EXPECT_EQ(fine.reoriented_count(), 0);
    // The same polynomial map on each part: areas agree to rounding
    test::expect_close(fine.area(), mesh.area(), 1e-13);
    EXPECT_EQ(fine.nodes().leftCols(mesh.node_count()), mesh.nodes());
    const PointLocator coarse(mesh);
    for (Index n = 0; n < fine.node_count(); ++n)
      EXPECT_TRUE(coarse.locate(fine.nodes().col(n)).has_value()) << n;
  }
}

// (2·2nx + 1)(2·2ny + 1) - 2nx·2ny nodes
TEST(Refine, OfARectangleIsTheRectangleWithHalfTheEdges) {
  const Q8Mesh fine = refine(make_rectangle({.length = 6.0, .width = 2.0, .nx = 3, .ny = 2}));
  const Q8Mesh same = make_rectangle({.length = 6.0, .width = 2.0, .nx = 6, .ny = 4});
  ASSERT_EQ(fine.node_count(), same.node_count());
  const PointLocator locator(same);
  for (Index n = 0; n < same.node_count(); ++n) {
    double nearest = 1.0;
    for (Index m = 0; m < fine.node_count(); ++m)
      nearest = std::min(nearest, (fine.nodes().col(m) - same.nodes().col(n)).norm());
    EXPECT_LT(nearest, 1e-14);
  }
}

}  // namespace
}  // namespace floe::mesh
