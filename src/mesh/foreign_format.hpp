#pragma once

#include <string>
#include <string_view>

namespace floe::mesh {

/// What a file is that does not begin as a Gmsh .msh of version 2 or later: "gzip archive", "MSH
/// 1", "GiD mesh", … ; empty if it begins as one.
std::string foreign_format(std::string_view bytes);

}  // namespace floe::mesh
