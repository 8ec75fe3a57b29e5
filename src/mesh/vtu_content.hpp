#pragma once

#include "mesh/file_content.hpp"

#include <string>
#include <string_view>

namespace floe::mesh {

/// Whether the bytes begin as one of VTK's XML files, whatever kind of data it holds.
bool is_vtk_xml(std::string_view bytes);

/// Parses the bytes of a VTU file. Throws MeshError that names the file and the array.
FileContent parse_vtu(std::string_view bytes, const std::string& file_name);

}  // namespace floe::mesh
