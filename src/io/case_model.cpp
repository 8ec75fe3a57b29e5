#include "io/case_sections.hpp"

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

std::vector<std::string> plate_keys() {
  return {"thickness",        "youngs_modulus", "poisson_ratio", "density",
          "shear_correction", "loss_factor",    "mesh"};
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

MeshSource read_mesh_source(const Section& mesh, const std::filesystem::path& folder) {
  const bool rectangle = mesh.find("rectangle"), file = mesh.find("file");
  if (rectangle == file)
    mesh.source().refuse(mesh.place(),
                         fmt::format("{} {} (must hold either rectangle or file)",
                                     rectangle ? "ambiguous" : "missing", mesh.name()));
  if (rectangle) return read_rectangle(mesh);
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

void read_plate(const Section& root, Case& data) {
  const Section plate = root.table("plate", plate_keys());
  const NumberRule poisson{"", "must be greater than -1 and less than 0.5",
                           [](double x) { return x > -1.0 && x < 0.5; }};
  const NumberRule correction{"", "must be greater than 0 and at most 1",
                              [](double x) { return x > 0.0 && x <= 1.0; }};
  const NumberRule loss{"", "must be 0 to 1", [](double x) { return x >= 0.0 && x <= 1.0; }};
  auto& p = data.plate;
  p.thickness = plate.number("thickness", kPositive("m"));
  p.youngs_modulus = plate.number("youngs_modulus", kPositive("N/m²"));
  p.poisson_ratio = plate.number("poisson_ratio", poisson);
  p.density = plate.number("density", kPositive("kg/m³"));
  p.shear_correction = plate.number_or("shear_correction", correction, p.shear_correction);
  p.loss_factor = plate.number_or("loss_factor", loss, p.loss_factor);
  if (p.density >= data.water.density)
    plate.source().refuse(
        plate.find("density")->source(),
        fmt::format("invalid plate.density = {} kg/m³ (must be less than water.density = {} "
                    "kg/m³, or the plate sinks)",
                    p.density, data.water.density));
}

void read_meshes(const Section& root, const std::filesystem::path& folder, Case& data) {
  data.mesh = read_mesh_source(root.table("mesh", {"rectangle", "file"}), folder);
  const Section plate = root.table("plate", plate_keys());
  if (!plate.find("mesh")) return;
  data.plate_mesh = {read_mesh_source(plate.table("mesh", {"rectangle", "file"}), folder)};
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
                          const std::vector<std::string>& ready,
                          const std::vector<std::string>& later) {
    const std::string chosen = solver.text_or(key, fallback);
    const auto is_in = [&](const std::vector<std::string>& names) {
      return std::find(names.begin(), names.end(), chosen) != names.end();
    };
    if (is_in(ready)) return chosen;
    const std::string given =
        fmt::format("{} = {}", solver.full_name(key), shown(*solver.find(key)));
    if (is_in(later))
      solver.source().refuse(
          solver.find(key)->source(),
          fmt::format("{} is not available yet in this version ({})", given, FLOE_VERSION));
    solver.source().refuse(solver.find(key)->source(),
                           fmt::format("invalid {} (must be {})", given, fmt::join(ready, " or ")));
  };
  const std::string method =
      choose("method", "auto", {"auto", "dense", "lattice", "pfft", "fmm"}, {});
  choose("route", "modal", {"modal"}, {"direct"});
  for (const SolverMethod candidate :
       {SolverMethod::kDense, SolverMethod::kLattice, SolverMethod::kPfft, SolverMethod::kFmm})
    if (method == method_name(candidate)) data.method = candidate;
  const NumberRule tolerance{"", "must be 1e-9 to 1e-1",
                             [](double x) { return x >= 1e-9 && x <= 1e-1; }};
  data.tolerance = solver.number_or("tolerance", tolerance, data.tolerance);
}

}  // namespace floe::io
