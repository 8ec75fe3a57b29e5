#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace floe::mesh {

/// Elements with a name in common: a physical group of Gmsh.
struct ElementGroup {
  std::string name;
  std::vector<Index> elements;  ///< 0-based, rising
};

/// A mesh that was read, with what the user should know about the reading.
struct MeshFile {
  Q8Mesh mesh;
  std::vector<std::string> notices;
  std::vector<ElementGroup> groups = {};  ///< may overlap and leave elements out
};

/// Reads a mesh of quadrilaterals, Gmsh or VTU; the content tells which, not the name.
///
/// Gmsh: `.msh` 2.2 and 4.1, ASCII and binary (little-endian); physical surfaces become groups of
/// elements under their names (their numbers where they have none). VTU: unstructured grids of
/// version 0.1, 1.0 or 2.x in one piece, data in the text, in base64 or appended, raw or in base64,
/// plain or compressed by zlib; integer cell data named "region" or "gmsh:physical" become groups
/// under their numbers.
///
/// Quadratic quads with 8 nodes are taken as they are, quads with 9 nodes lose their centre node,
/// quads with 4 nodes are raised (shared mid-side nodes on straight edges; a quadratic neighbour's
/// node where there is one). Point and line elements, and nodes that no quad uses, are dropped with
/// one notice. z must be 0 to 1e-6 of the mesh's size. Elements keep the order of the file's quads,
/// nodes that of the file's nodes.
///
/// Throws MeshError that names the file, the place and what was found: no such file, directories
/// and pipes, triangles and volumes, other versions, other programs' formats by name, truncated
/// files, counts larger than the file, unknown nodes, and what Q8Mesh refuses. Throws FileError
/// when reading fails midway.
MeshFile read_mesh(const std::filesystem::path& path);

}  // namespace floe::mesh
