#include <floe/analysis.hpp>

#include <fmt/format.h>

namespace floe {

mesh::MeshFile load_mesh(const MeshSource& source) {
  if (const auto* rectangle = std::get_if<mesh::RectangleOptions>(&source))
    return {mesh::make_rectangle(*rectangle), {}};
  mesh::MeshFile file = mesh::read_mesh(std::get<std::filesystem::path>(source));
  if (file.mesh.reoriented_count() > 0)
    file.notices.push_back(
        fmt::format("{} elements were clockwise and were turned", file.mesh.reoriented_count()));
  return file;
}

}  // namespace floe
