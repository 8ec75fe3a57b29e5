#pragma once

#include <floe/mesh/gmsh.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace floe::mesh {

/// A quadrilateral of a .msh file: corners, then mid-sides, then the centre, as positions in
/// GmshContent::coordinates.
struct GmshQuad {
  int node_count;  ///< 4, 8 or 9
  std::array<Index, 9> nodes;
};

/// What stands in a .msh file, before it is made a mesh.
struct GmshContent {
  std::vector<Eigen::Vector3d> coordinates;  ///< in the order of the file [m]
  std::unordered_map<std::int64_t, Index> node_of_tag;
  std::vector<GmshQuad> quads;
  Index point_elements = 0;
  Index line_elements = 0;
  std::map<std::string, Index> refused;  ///< elements that no plate has: name, count
};

/// Parses the bytes of a .msh file, 2.2 or 4.1, ASCII or binary. Throws MeshError that names the
/// file and the line (binary: the byte).
GmshContent parse_gmsh(std::string_view bytes, const std::string& file_name);

/// `read_gmsh` of a file with that name and content.
MeshFile read_gmsh_bytes(std::string_view bytes, const std::string& file_name);

}  // namespace floe::mesh
