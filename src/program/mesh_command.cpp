#include "program/commands.hpp"
#include "program/exit_code.hpp"
#include "program/replaceable.hpp"

#include <floe/mesh/gmsh.hpp>
#include <floe/mesh/mesh_quality.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>

namespace floe::program {

void make_mesh(const MeshOptions& options) {
  const mesh::Q8Mesh mesh = [&] {
    try {
      return mesh::make_shape(options.shape);
    } catch (const MeshError&) {
      throw;
    } catch (const InputError& error) {
      throw UsageError(error.what());  // the sizes came from the command line
    }
  }();
  require_replaceable(options.output, "Gmsh mesh", {"$MeshFormat"});
  mesh::write_gmsh(options.output, mesh);
  const mesh::MeshQuality quality = mesh::measure_quality(mesh);
  print(fmt::format("{}: {}, {}, {}, {:.6g} m², edges of {:.4g} to {:.4g} m\n",
                    options.output.string(), counted(mesh.node_count(), "node"),
                    counted(mesh.element_count(), "element"), counted(mesh.piece_count(), "piece"),
                    mesh.area(), quality.shortest_edge, quality.longest_edge));
}

}  // namespace floe::program
