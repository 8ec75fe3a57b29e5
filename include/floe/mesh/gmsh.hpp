#pragma once

#include <floe/mesh/mesh_file.hpp>
#include <floe/mesh/q8_mesh.hpp>

#include <filesystem>
#include <vector>

namespace floe::mesh {

/// Writes `.msh` 4.1 ASCII, each group a physical surface, elements that no group has as the
/// surface "plate"; numbers are shortest round-trip. Groups must not overlap; their elements come
/// first. The file is complete or absent. Throws FileError.
void write_gmsh(const std::filesystem::path& path, const Q8Mesh& mesh,
                const std::vector<ElementGroup>& groups = {});

}  // namespace floe::mesh
