#pragma once

#include "mesh/file_content.hpp"
#include "test_case.hpp"
#include "test_paths.hpp"

#include <floe/mesh/mesh_file.hpp>
#include <floe/numeric/error.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

/// Files and texts for the tests of the Gmsh reader.
namespace floe::test {

/// Content of a file.
inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A file of tests/data/mesh.
inline std::filesystem::path data_file(const std::string& name) {
  return std::filesystem::path(FLOE_TEST_DATA) / "mesh" / name;
}

/// The message of the MeshError that the bytes give; "" if they are a mesh
inline std::string error_of(const std::string& bytes) {
  try {
    mesh::read_mesh_bytes(bytes, "a.msh");
  } catch (const MeshError& error) {
    return error.what();
  }
  return "";
}

/// A square of one element with 8 nodes, as MSH 2.2; node and element lines can be added to
inline std::string square_22(const std::string& more_nodes = "", int more_node_count = 0,
                             const std::string& more_elements = "", int more_element_count = 0) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(8 + more_node_count) +
         "\n1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 2 0\n5 1 0 0\n6 2 1 0\n7 1 2 0\n8 0 1 0\n" + more_nodes +
         "$EndNodes\n$Elements\n" + std::to_string(1 + more_element_count) +
         "\n1 16 2 0 1 1 2 3 4 5 6 7 8\n" + more_elements + "$EndElements\n";
}

/// The same as MSH 4.1
inline std::string square_41() {
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n2 8 1 8\n0 1 0 4\n1\n2\n3\n4\n0 0 0\n2 0 "
         "0\n"
         "2 2 0\n0 2 0\n2 1 0 4\n5\n6\n7\n8\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n$EndNodes\n"
         "$Elements\n1 1 1 1\n2 1 16 1\n1 1 2 3 4 5 6 7 8\n$EndElements\n";
}

/// The same mesh in every dialect; see the README beside them.
inline const std::vector<std::string>& every_file() {
  static const std::vector<std::string> names = {
      "sector_quad8_22.msh",          "sector_quad8_22_bin.msh", "sector_quad8_41.msh",
      "sector_quad8_41_bin.msh",      "sector_quad9_22.msh",     "sector_quad9_22_bin.msh",
      "sector_quad9_41.msh",          "sector_quad9_41_bin.msh", "sector_parametric_41.msh",
      "sector_parametric_41_bin.msh", "sector_quad4_22.msh",     "sector_quad4_22_bin.msh",
      "sector_quad4_41.msh",          "sector_quad4_41_bin.msh"};
  return names;
}

}  // namespace floe::test
