#pragma once

#include <floe/mesh/mesh_file.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace floe::mesh {

/// A quadrilateral of a mesh file: corners, then mid-sides, then the centre, as positions in
/// FileContent::coordinates.
struct FileQuad {
  int node_count;  ///< 4, 8 or 9
  std::array<Index, 9> nodes;
  std::int64_t tag = 0;  ///< in the file; 0: it numbers no elements
};

/// What stands in a mesh file of any format, before it is made a mesh.
struct FileContent {
  std::vector<Eigen::Vector3d> coordinates;  ///< in the order of the file [m]
  std::vector<std::int64_t> tags;            ///< of the nodes; empty: the file numbers none
  std::vector<FileQuad> quads;
  std::vector<ElementGroup> groups;  ///< of quads
  Index point_elements = 0;
  Index line_elements = 0;
  std::map<std::string, Index> refused;  ///< elements that no plate has: name, count
};

/// Makes it a mesh: drops what no quad uses, raises 4-node quads, demands the plane z = 0. Throws
/// MeshError that names the file.
MeshFile make_mesh_file(const FileContent& content, const std::string& file_name);

/// `read_mesh` of a file with that name and content.
MeshFile read_mesh_bytes(std::string_view bytes, const std::string& file_name);

}  // namespace floe::mesh
