#include "program/commands.hpp"
#include "program/exit_code.hpp"

#include <floe/mesh/gmsh.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>

namespace floe::program {

void make_rectangle_mesh(const RectangleMeshOptions& options) {
  const mesh::Q8Mesh mesh = [&] {
    try {
      return mesh::make_rectangle(options.rectangle);
    } catch (const InputError& error) {
      throw UsageError(error.what());  // the sizes came from the command line
    }
  }();
  mesh::write_gmsh(options.output, mesh);
  print(fmt::format("{}: {}, {}\n", options.output.string(), counted(mesh.node_count(), "node"),
                    counted(mesh.element_count(), "element")));
}

}  // namespace floe::program
