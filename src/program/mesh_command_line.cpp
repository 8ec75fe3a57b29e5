#include "program/mesh_command_line.hpp"

#include "program/commands.hpp"

#include <floe/mesh/shapes.hpp>

#include <algorithm>
#include <memory>

namespace floe::program {
namespace {

// What every shape's command takes besides its sizes, and what it does
template <typename Options>
void finish_command(CLI::App& command, const std::shared_ptr<Options>& shape,
                    std::function<void()>& action) {
  const auto output = std::make_shared<std::filesystem::path>();
  command.add_option("-o", *output, "file to write")->required()->type_name("FILE.msh");
  command.callback([&action, shape, output] {
    action = [shape, output] { make_mesh({*shape, *output}); };
  });
}

template <typename Options>
void add_shape(CLI::App& mesh, std::function<void()>& action) {
  const auto shape = std::make_shared<Options>();
  const mesh::ShapeKeys<Options> keys = shape_keys(*shape);
  CLI::App& command = *mesh.add_subcommand(keys.name, std::string(keys.about) + " (Gmsh 4.1)");
  const auto flag = [](std::string key) {
    std::replace(key.begin(), key.end(), '_', '-');
    return "--" + key;
  };
  for (const auto& length : keys.lengths)
    command.add_option(flag(length.key), (*shape).*length.member, length.about)->required();
  for (const auto& count : keys.counts)
    command.add_option(flag(count.key), (*shape).*count.member, count.about)->required();
  finish_command(command, shape, action);
}

void add_rectangle(CLI::App& mesh, std::function<void()>& action) {
  const auto shape = std::make_shared<mesh::RectangleOptions>();
  CLI::App& command = *mesh.add_subcommand("rectangle", "mesh of a rectangle (Gmsh 4.1)");
  command.add_option("--length", shape->length, "extent in x [m]")->required();
  command.add_option("--width", shape->width, "extent in y [m]")->required();
  command.add_option("--nx", shape->nx, "elements along x")->required();
  command.add_option("--ny", shape->ny, "elements along y")->required();
  command.add_option("--grading", shape->grading,
                     "longest over shortest edge, 1 … 100; edges shrink towards the sides");
  finish_command(command, shape, action);
}

}  // namespace

void add_mesh_commands(CLI::App& app, std::function<void()>& action) {
  CLI::App& mesh = *app.add_subcommand("mesh", "make a mesh");
  mesh.require_subcommand(1);
  add_rectangle(mesh, action);
  add_shape<mesh::DiscOptions>(mesh, action);
  add_shape<mesh::RingOptions>(mesh, action);
  add_shape<mesh::LShapeOptions>(mesh, action);
  add_shape<mesh::ModuleArrayOptions>(mesh, action);
}

}  // namespace floe::program
