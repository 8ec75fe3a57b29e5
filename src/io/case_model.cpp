#include "io/case_sections.hpp"

#include <floe/io/case_file.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace floe::io {
namespace {

constexpr int kMostElements = 100'000'000;

constexpr NumberRule kPositive(const char* unit) { return {unit, "must be positive", is_positive}; }

const std::vector<std::string>& mesh_keys() {
  static const std::vector<std::string> keys = {"rectangle", "disc",    "ring",
                                                "lshape",    "modules", "file"};
  return keys;
}

mesh::RectangleOptions read_rectangle(const Section& mesh) {
  const Section table = mesh.table("rectangle", {"length", "width", "nx", "ny", "grading"});
  const NumberRule grading{"", "must be 1 to 100", [](double x) { return x >= 1.0 && x <= 100.0; }};
  const mesh::RectangleOptions options{.length = table.number("length", kPositive("m")),
                                       .width = table.number("width", kPositive("m")),
                                       .nx = table.integer("nx", 1, kMostElements),
                                       .ny = table.integer("ny", 1, kMostElements),
                                       .grading = table.number_or("grading", grading, 1.0)};
  if (static_cast<double>(options.nx) * options.ny > kMostElements)
    throw BudgetError(table.source().place(table.place()) +
                      fmt::format("invalid {} = {} × {} elements (must be at most {})",
                                  table.name(), options.nx, options.ny, kMostElements));
  return options;
}

std::filesystem::path read_mesh_path(const Section& mesh, const std::filesystem::path& folder) {
  const toml::node& node = *mesh.find("file");
  const std::filesystem::path path = folder / mesh.text_or("file", "");
  const auto refuse = [&](const std::string& why) {
    throw MeshError(mesh.source().place(node.source()) +
                    fmt::format("invalid {} = {} ({})", mesh.full_name("file"), shown(node), why));
  };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    refuse(std::string("cannot read: ") + std::strerror(ENOENT));
  if (error) refuse("cannot read: " + error.message());
  if (!std::filesystem::is_regular_file(status)) refuse("must be a regular file");
  return path;
}

// Any other shape that floe meshes
template <typename Shape>
MeshSource read_shape(const Section& mesh) {
  Shape shape;
  const mesh::ShapeKeys<Shape> keys = shape_keys(shape);
  std::vector<std::string> known;
  for (const auto& length : keys.lengths) known.push_back(length.key);
  for (const auto& count : keys.counts) known.push_back(count.key);
  const Section table = mesh.table(keys.name, known);
  for (const auto& length : keys.lengths)
    shape.*length.member = table.number(length.key, kPositive("m"));
  for (const auto& count : keys.counts)
    shape.*count.member = table.integer(count.key, 1, kMostElements);
  return shape;
}

MeshSource read_mesh_source(const Section& mesh, const std::filesystem::path& folder) {
  std::vector<std::string> given;
  for (const std::string& key : mesh_keys())
    if (mesh.find(key)) given.push_back(key);
  if (given.size() != 1)
    mesh.source().refuse(mesh.place(), fmt::format("{} {} (must hold one of {})",
                                                   given.empty() ? "missing" : "ambiguous",
                                                   mesh.name(), fmt::join(mesh_keys(), ", ")));
  const std::string& key = given.front();
  if (key == "rectangle") return read_rectangle(mesh);
  if (key == "disc") return read_shape<mesh::DiscOptions>(mesh);
  if (key == "ring") return read_shape<mesh::RingOptions>(mesh);
  if (key == "lshape") return read_shape<mesh::LShapeOptions>(mesh);
  if (key == "modules") return read_shape<mesh::ModuleArrayOptions>(mesh);
  return read_mesh_path(mesh, folder);
}

}  // namespace

void read_water(const Section& root, Case& data) {
  const Section water = root.table("water", {"depth", "density", "gravity"});
  const NumberRule depth{"m", "must be positive or inf", [](double x) { return x > 0.0; }};
  const NumberRule not_a_film{"m", "must be at least 0.001 or inf",
                              [](double x) { return !(x > 0.0) || x >= 1e-3; }};
  water.number("depth", not_a_film);
  data.water.depth = water.number("depth", depth);
  data.water.density = water.number_or("density", kPositive("kg/m³"), data.water.density);
  data.water.gravity = water.number_or("gravity", kPositive("m/s²"), data.water.gravity);
}

void read_meshes(const Section& root, const std::filesystem::path& folder, Case& data) {
  data.mesh = read_mesh_source(root.table("mesh", mesh_keys()), folder);
  const Section plate = root.table("plate", plate_keys());
  if (!plate.find("mesh")) return;
  data.plate_mesh = {read_mesh_source(plate.table("mesh", mesh_keys()), folder)};
}

void read_modes(const Section& root, Case& data) {
  if (!root.find("modes")) return;
  constexpr int kLeastModes = 3, kMostModes = 100'000;
  data.mode_count =
      root.table("modes", {"count"}).integer_or("count", kLeastModes, kMostModes, data.mode_count);
}

void read_solver(const Section& root, Case& data) {
  if (!root.find("solver")) return;
  const Section solver = root.table("solver", {"method", "route", "tolerance"});
  const auto choose = [&](const std::string& key, const std::string& fallback,
                          const std::vector<std::string>& known) {
    const std::string chosen = solver.text_or(key, fallback);
    if (std::find(known.begin(), known.end(), chosen) != known.end()) return chosen;
    const std::string nearest = nearest_name(chosen, known);
    solver.source().refuse(solver.find(key)->source(),
                           fmt::format("invalid {} = {} (must be {}{})", solver.full_name(key),
                                       shown(*solver.find(key)), fmt::join(known, " or "),
                                       nearest.empty() ? "" : "; did you mean " + nearest + "?"));
  };
  const std::string method = choose("method", "auto", {"auto", "dense", "lattice", "pfft", "fmm"});
  const std::string route = choose("route", "modal", {"modal", "direct"});
  if (route == route_name(SolverRoute::kDirect)) data.route = SolverRoute::kDirect;
  for (const SolverMethod candidate :
       {SolverMethod::kDense, SolverMethod::kLattice, SolverMethod::kPfft, SolverMethod::kFmm})
    if (method == method_name(candidate)) data.method = candidate;
  const NumberRule tolerance{"", "must be 1e-9 to 1e-1",
                             [](double x) { return x >= 1e-9 && x <= 1e-1; }};
  data.tolerance = solver.number_or("tolerance", tolerance, data.tolerance);
}

}  // namespace floe::io
