#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace floe::mesh {

/// A mesh that was read, with what the user should know about the reading.
struct MeshFile {
  Q8Mesh mesh;
  std::vector<std::string> notices;
};

/// Reads a Gmsh mesh: `.msh` 2.2 and 4.1, ASCII and binary (little-endian). Quadratic quads with 8
/// nodes are taken as they are, quads with 9 nodes lose their centre node, quads with 4 nodes are
/// raised (shared mid-side nodes on straight edges). Point and line elements, and nodes that no
/// quad uses, are dropped with one notice. z must be 0 to 1e-6 of the mesh's size.
/// Throws MeshError that names the file, the place and what was found: triangles and volumes, other
/// versions, other programs' .msh, truncated files, counts larger than the file, unknown node tags.
/// Throws FileError when the file cannot be read.
MeshFile read_gmsh(const std::filesystem::path& path);

/// Writes `.msh` 4.1 ASCII with one physical surface "plate"; numbers are shortest round-trip.
void write_gmsh(const std::filesystem::path& path, const Q8Mesh& mesh);

}  // namespace floe::mesh
