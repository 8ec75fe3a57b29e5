#include <floe/analysis.hpp>

#include <fmt/format.h>

namespace floe {
namespace {

mesh::MeshFile make(const mesh::RectangleOptions& shape) {
  return {mesh::make_rectangle(shape), {}};
}
mesh::MeshFile make(const mesh::DiscOptions& shape) { return {mesh::make_disc(shape), {}}; }
mesh::MeshFile make(const mesh::RingOptions& shape) { return {mesh::make_ring(shape), {}}; }
mesh::MeshFile make(const mesh::LShapeOptions& shape) { return {mesh::make_l_shape(shape), {}}; }
mesh::MeshFile make(const mesh::ModuleArrayOptions& shape) {
  return {mesh::make_module_array(shape), {}};
}

mesh::MeshFile make(const std::filesystem::path& path) {
  mesh::MeshFile file = mesh::read_mesh(path);
  if (file.mesh.reoriented_count() > 0)
    file.notices.push_back(
        fmt::format("{} elements were clockwise and were turned", file.mesh.reoriented_count()));
  return file;
}

}  // namespace

mesh::MeshFile load_mesh(const MeshSource& source) {
  return std::visit([](const auto& given) { return make(given); }, source);
}

}  // namespace floe
