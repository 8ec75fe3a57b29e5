#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <filesystem>

namespace floe::mesh {

/// Writes `.msh` 4.1 ASCII with one physical surface "plate"; numbers are shortest round-trip.
/// The file is complete or absent. Throws FileError.
void write_gmsh(const std::filesystem::path& path, const Q8Mesh& mesh);

}  // namespace floe::mesh
