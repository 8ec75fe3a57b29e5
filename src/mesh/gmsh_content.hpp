#pragma once

#include "mesh/file_content.hpp"

#include <string>
#include <string_view>

namespace floe::mesh {

/// Parses the bytes of a .msh file, 2.2 or 4.1, ASCII or binary. Throws MeshError that names the
/// file and the line (binary: the byte).
FileContent parse_gmsh(std::string_view bytes, const std::string& file_name);

}  // namespace floe::mesh
