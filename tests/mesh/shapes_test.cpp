#include <floe/bem/element_lattice.hpp>
#include <floe/mesh/mesh_quality.hpp>
#include <floe/mesh/shapes.hpp>
#include <floe/numeric/error.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace floe::mesh {
namespace {

constexpr double kPi = std::numbers::pi;

// Edges of element sides that belong to one element only, as triples of nodes
std::vector<std::array<Index, 3>> outline_edges(const Q8Mesh& mesh) {
  std::vector<int> elements_at(mesh.node_count(), 0);
  for (const Index node : mesh.elements().reshaped()) ++elements_at[node];
  std::vector<std::array<Index, 3>> edges;
  for (Index e = 0; e < mesh.element_count(); ++e)
    for (int side = 0; side < 4; ++side)
      if (elements_at[mesh.elements()(4 + side, e)] == 1)
        edges.push_back({mesh.elements()(side, e), mesh.elements()(4 + side, e),
                         mesh.elements()((side + 1) % 4, e)});
  return edges;
}

// Area under the arcs of a circle, replaced by parabolas through equidistant points of it, n in
// all: Simpson's rule on ½ (x dy - y dx) of one arc with half angle a is r² sin a (4 - cos a) / 3
double parabolic_disc_area(double radius, int n) {
  const double a = kPi / n;
  return n * radius * radius * std::sin(a) * (4.0 - std::cos(a)) / 3.0;
}

TEST(Disc, HasItsOutlineOnTheCircleAndTheAreaOfItsParabolas) {
  for (const double size : {100.0, 30.0, 10.0, 3.0}) {
    const Q8Mesh mesh = make_disc({.radius = 50.0, .element_size = size});
    const auto edges = outline_edges(mesh);
    EXPECT_EQ(edges.size() % 4, 0u);
    for (const auto& edge : edges)
      for (const Index node : edge) EXPECT_NEAR(mesh.nodes().col(node).norm(), 50.0, 1e-13 * 50.0);
    EXPECT_NEAR(mesh.area(), parabolic_disc_area(50.0, static_cast<int>(edges.size())),
                1e-12 * mesh.area());
    EXPECT_EQ(mesh.piece_count(), 1);
    EXPECT_EQ(mesh.reoriented_count(), 0);
    // Euler: corners - edges + elements = 1, edges shared by two but for the outline
    const Index sides = (4 * mesh.element_count() + static_cast<Index>(edges.size())) / 2;
    EXPECT_EQ(mesh.node_count(), 2 * sides + 1 - mesh.element_count());
  }
}

TEST(Disc, HasGoodElementsNoLargerThanAsked) {
  for (const double size : {20.0, 10.0, 3.0, 1.0}) {
    const MeshQuality quality = measure_quality(make_disc({.radius = 50.0, .element_size = size}));
    EXPECT_LE(quality.longest_edge, size) << size;
    EXPECT_GE(quality.shortest_edge, size / 3.0) << size;
    EXPECT_LE(quality.worst_aspect_ratio, 2.0) << size;
    EXPECT_LE(quality.largest_edge_jump, 2.0) << size;
    EXPECT_GE(quality.worst_jacobian_ratio, 0.5) << size;
  }
}

TEST(Ring, HasItsOutlineOnTwoCirclesAndTheAreaBetweenTheirParabolas) {
  for (const double size : {100.0, 10.0, 3.0}) {
    const Q8Mesh mesh =
        make_ring({.inner_radius = 30.0, .outer_radius = 50.0, .element_size = size});
    const auto edges = outline_edges(mesh);
    const int around = static_cast<int>(edges.size()) / 2;
    int inner = 0, outer = 0;
    for (const auto& edge : edges)
      for (const Index node : edge) {
        const double radius = mesh.nodes().col(node).norm();
        EXPECT_NEAR(radius, radius < 40.0 ? 30.0 : 50.0, 1e-13 * 50.0);
        ++(radius < 40.0 ? inner : outer);
      }
    EXPECT_EQ(inner, 3 * around);
    EXPECT_EQ(outer, 3 * around);
    EXPECT_NEAR(mesh.area(), parabolic_disc_area(50.0, around) - parabolic_disc_area(30.0, around),
                1e-12 * mesh.area());
    // Euler: corners - edges + elements = 0
    const Index sides = (4 * mesh.element_count() + 2 * around) / 2;
    EXPECT_EQ(mesh.node_count(), 2 * sides - mesh.element_count());
    EXPECT_EQ(mesh.piece_count(), 1);
  }
}

TEST(Ring, HasNearlySquareElementsForAnyHole) {
  for (const double inner : {0.5, 5.0, 30.0, 45.0}) {
    const Q8Mesh mesh =
        make_ring({.inner_radius = inner, .outer_radius = 50.0, .element_size = 3.0});
    const MeshQuality quality = measure_quality(mesh);
    EXPECT_LE(quality.longest_edge, 3.0) << inner;
    EXPECT_LE(quality.worst_aspect_ratio, 1.5) << inner;
    EXPECT_LE(quality.largest_edge_jump, 1.5) << inner;
    EXPECT_GE(quality.worst_jacobian_ratio, 0.8) << inner;
  }
}

TEST(LShape, HasEqualElementsOnALatticeAndItsArea) {
  const Q8Mesh mesh = make_l_shape({.length = 120.0,
                                    .width = 100.0,
                                    .cut_length = 80.0,
                                    .cut_width = 60.0,
                                    .element_size = 5.0});
  EXPECT_EQ(mesh.element_count(), 288);
  EXPECT_EQ(mesh.node_count(), 953);  // as meshes/lshape.msh, made by Gmsh
  EXPECT_NEAR(mesh.area(), 7200.0, 1e-9);
  EXPECT_EQ(mesh.lower(), Point2(-60.0, -50.0));
  EXPECT_EQ(mesh.upper(), Point2(60.0, 50.0));
  const auto lattice = bem::find_element_lattice(mesh);
  ASSERT_TRUE(lattice);
  EXPECT_EQ(lattice->nx, 24);
  EXPECT_EQ(lattice->ny, 20);
}

TEST(LShape, ShortensElementsUntilTheyFitTheCut) {
  // A third of 100 m: 11 elements of 9.1 m do not fit, 12 of 8.3 m do
  const Q8Mesh mesh = make_l_shape({.length = 100.0,
                                    .width = 100.0,
                                    .cut_length = 100.0 / 3.0,
                                    .cut_width = 50.0,
                                    .element_size = 9.5});
  const MeshQuality quality = measure_quality(mesh);
  EXPECT_NEAR(quality.shortest_edge, 100.0 / 12.0, 1e-9);
  EXPECT_NEAR(quality.longest_edge, 100.0 / 12.0, 1e-9);
  EXPECT_NEAR(mesh.area(), 1e4 * (1.0 - 1.0 / 6.0), 1e-8);
}

TEST(LShape, RefusesCutsThatNoEqualElementsFit) {
  const LShapeOptions good{
      .length = 100.0, .width = 100.0, .cut_length = 50.0, .cut_width = 50.0, .element_size = 10.0};
  EXPECT_NO_THROW(make_l_shape(good));
  LShapeOptions bad = good;
  bad.cut_length = 100.0 / kPi;
  EXPECT_THROW(make_l_shape(bad), InputError);
  bad = good;
  bad.cut_width = 100.0;
  EXPECT_THROW(make_l_shape(bad), InputError);
}

TEST(ModuleArray, HasSeparateEqualModulesOnOneLatticeWhereTheGapFits) {
  const ModuleArrayOptions options{.module_length = 20.0,
                                   .module_width = 10.0,
                                   .modules_x = 4,
                                   .modules_y = 3,
                                   .gap = 2.0,
                                   .element_size = 2.4};
  const Q8Mesh mesh = make_module_array(options);
  EXPECT_EQ(mesh.piece_count(), 12);
  EXPECT_EQ(mesh.element_count(), 12 * 10 * 5);
  EXPECT_EQ(mesh.node_count(), 12 * (21 * 11 - 50));
  EXPECT_NEAR(mesh.area(), 12 * 200.0, 1e-9);
  EXPECT_NEAR(mesh.upper().x(), 0.5 * (4 * 20.0 + 3 * 2.0), 1e-12);
  EXPECT_NEAR(mesh.lower().y(), -0.5 * (3 * 10.0 + 2 * 2.0), 1e-12);
  ASSERT_TRUE(bem::find_element_lattice(mesh));
  EXPECT_EQ(bem::find_element_lattice(mesh)->nx, 43);
  // The first module is the lower left one, the next its neighbour in x
  EXPECT_EQ(mesh.element_piece()[0], 0);
  EXPECT_NEAR(mesh.element_nodes(50)(0, 0), -43.0 + 22.0, 1e-12);
}

TEST(ModuleArray, TakesAGapThatFitsNoElements) {
  const Q8Mesh mesh = make_module_array({.module_length = 20.0,
                                         .module_width = 10.0,
                                         .modules_x = 2,
                                         .modules_y = 1,
                                         .gap = 0.3,
                                         .element_size = 5.0});
  EXPECT_EQ(mesh.element_count(), 2 * 4 * 2);
  EXPECT_FALSE(bem::find_element_lattice(mesh));
}

template <typename Options>
void expect_refusals(const Options& good) {
  EXPECT_NO_THROW(make_shape(good));
  const ShapeKeys<Options> keys = shape_keys(good);
  for (const auto& length : keys.lengths)
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
      Options shape = good;
      shape.*length.member = bad;
      EXPECT_THROW(make_shape(shape), InputError) << keys.name << " " << length.key << " " << bad;
    }
  for (const auto& count : keys.counts) {
    Options shape = good;
    shape.*count.member = 0;
    EXPECT_THROW(make_shape(shape), InputError) << keys.name << " " << count.key;
  }
  Options shape = good;
  shape.element_size = 1e-9;
  EXPECT_THROW(make_shape(shape), InputError) << keys.name;
}
TEST(Shapes, RefuseSizesAndCountsThatAreNotPositiveAndTooManyElements) {
  expect_refusals(DiscOptions{.radius = 2.0, .element_size = 1.0});
  expect_refusals(RingOptions{.inner_radius = 1.0, .outer_radius = 2.0, .element_size = 1.0});
  expect_refusals(LShapeOptions{
      .length = 2.0, .width = 2.0, .cut_length = 1.0, .cut_width = 1.0, .element_size = 1.0});
  expect_refusals(ModuleArrayOptions{.module_length = 2.0,
                                     .module_width = 2.0,
                                     .modules_x = 2,
                                     .modules_y = 1,
                                     .gap = 1.0,
                                     .element_size = 1.0});
  EXPECT_THROW(make_ring({.inner_radius = 2.0, .outer_radius = 2.0, .element_size = 1.0}),
               InputError);
}

}  // namespace
}  // namespace floe::mesh
