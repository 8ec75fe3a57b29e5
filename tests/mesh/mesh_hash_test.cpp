#include "tiny_meshes.hpp"

#include <floe/mesh/mesh_hash.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace floe::mesh {
namespace {

TEST(MeshHash, IsThirtyTwoHexadecimalDigits) {
  const std::string hash = mesh_hash(test::tiny_plate());
  EXPECT_EQ(hash.size(), 32u);
  EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(MeshHash, IsEqualForEqualMeshes) {
  EXPECT_EQ(mesh_hash(test::tiny_plate()), mesh_hash(test::tiny_plate()));
}

TEST(MeshHash, SeesTheLastBitOfACoordinate) {
  test::MeshArrays arrays = test::rectangle_arrays(3, 2, 3.0, 2.0);
  const std::string before = mesh_hash(arrays.build());
  arrays.nodes(0, 0) = std::nextafter(arrays.nodes(0, 0), 0.0);
  EXPECT_NE(mesh_hash(arrays.build()), before);
}

TEST(MeshHash, SeesTheNumbering) {
  test::MeshArrays arrays = test::rectangle_arrays(3, 2, 3.0, 2.0);
  const std::string before = mesh_hash(arrays.build());
  arrays.elements.col(0).swap(arrays.elements.col(1));
  EXPECT_NE(mesh_hash(arrays.build()), before);
}

TEST(MeshHash, DoesNotSeeTheSignOfZero) {
  test::MeshArrays arrays = test::rectangle_arrays(2, 2, 2.0, 2.0);
  const std::string before = mesh_hash(arrays.build());
  for (double& x : arrays.nodes.reshaped())
    if (x == 0.0) x = -0.0;
  EXPECT_EQ(mesh_hash(arrays.build()), before);
}

}  // namespace
}  // namespace floe::mesh
