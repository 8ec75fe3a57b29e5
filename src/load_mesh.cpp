#include <floe/analysis.hpp>

#include <fmt/format.h>

namespace floe {
namespace {

mesh::MeshFile load(const mesh::Shape& shape) { return {mesh::make_shape(shape), {}}; }

mesh::MeshFile load(const std::filesystem::path& path) {
  mesh::MeshFile file = mesh::read_mesh(path);
  if (file.mesh.reoriented_count() > 0)
    file.notices.push_back(fmt::format("{} clockwise element{} turned",
                                       file.mesh.reoriented_count(),
                                       file.mesh.reoriented_count() == 1 ? " was" : "s were"));
  return file;
}

}  // namespace

mesh::MeshFile load_mesh(const MeshSource& source) {
  return std::visit([](const auto& given) { return load(given); }, source);
}

}  // namespace floe
