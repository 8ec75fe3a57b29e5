#include "mesh/file_bytes.hpp"
#include "mesh/file_content.hpp"
#include "mesh/foreign_format.hpp"
#include "mesh/gmsh_content.hpp"
#include "mesh/vtu_content.hpp"

#include <floe/numeric/error.hpp>

namespace floe::mesh {

MeshFile read_mesh_bytes(std::string_view bytes, const std::string& file_name) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);  // UTF-8 byte order mark
  if (is_vtk_xml(bytes)) return make_mesh_file(parse_vtu(bytes, file_name), file_name);
  const std::string foreign = foreign_format(bytes);
  FLOE_VALIDATE_AS(MeshError, foreign.empty(),
                   file_name << ": found " << foreign
                             << " (must be a Gmsh mesh, MSH 2.2 or 4.1, or a VTU file)");
  return make_mesh_file(parse_gmsh(bytes, file_name), file_name);
}

MeshFile read_mesh(const std::filesystem::path& path) {
  return read_mesh_bytes(read_regular_file(path), path.string());
}

}  // namespace floe::mesh
