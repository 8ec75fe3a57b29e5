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
/// raised (shared mid-side nodes on straight edges; a quadratic neighbour's node where there is
/// one). Point and line elements, and nodes that no quad uses, are dropped with one notice. z must
/// be 0 to 1e-6 of the mesh's size. Elements keep the order of the file's quads.
/// Throws MeshError that names the file, the line (binary: the byte) and what was found: no such
/// file, directories and pipes, triangles and volumes, other versions, other programs' .msh,
/// truncated files, counts larger than the file, unknown node tags, and what Q8Mesh refuses.
/// Throws FileError when reading fails midway.
MeshFile read_gmsh(const std::filesystem::path& path);

/// Writes `.msh` 4.1 ASCII with one physical surface "plate"; numbers are shortest round-trip.
/// The file is complete or absent. Throws FileError.
void write_gmsh(const std::filesystem::path& path, const Q8Mesh& mesh);

}  // namespace floe::mesh
