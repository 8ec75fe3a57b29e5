#include "analysis_stages.hpp"

#include <floe/estimate.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/numeric/error.hpp>
#include <floe/plate/mindlin.hpp>
#include <floe/preflight.hpp>
#include <floe/response/stations.hpp>

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <numbers>

namespace floe {
namespace {

std::vector<std::string> names_of(const std::vector<NamedPoint>& points) {
  std::vector<std::string> names;
  for (const NamedPoint& point : points) names.push_back(point.name);
  return names;
}

Points2 positions_of(const std::vector<NamedPoint>& points) {
  Points2 positions(2, static_cast<Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    positions.col(static_cast<Index>(i)) = points[i].position;
  return positions;
}

// Stations of all lines, one after the other
SparseMatrix interpolation_to_lines(const mesh::Q8Mesh& mesh, const std::vector<NamedLine>& lines) {
  std::vector<std::string> names;
  std::vector<Point2> positions;
  for (const NamedLine& line : lines) {
    const Points2 stations = response::line_stations(line.from, line.to, line.count);
    for (int i = 0; i < line.count; ++i) {
      names.push_back(fmt::format("{} of line {}", i + 1, line.name));
      positions.emplace_back(stations.col(i));
    }
  }
  Points2 all(2, static_cast<Index>(positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i) all.col(static_cast<Index>(i)) = positions[i];
  return response::interpolation_to(mesh, all, names);
}

// From the nodes of the plate's own mesh to those of the fluid's
SparseMatrix interpolation_to_nodes(const mesh::Q8Mesh& plate, const mesh::Q8Mesh& fluid) {
  std::vector<std::string> names;
  for (Index node = 0; node < fluid.node_count(); ++node)
    names.push_back(fmt::format("of fluid node {}", node + 1));
  return response::interpolation_to(plate, fluid.nodes(), names);
}

// Reads a mesh and passes its notices on
mesh::MeshFile load_told(const MeshSource& source, Log& log) {
  mesh::MeshFile file = load_mesh(source);
  for (const std::string& notice : file.notices) log.notice(notice);
  return file;
}

plate::DryModes compute_modes(const Case& data, const mesh::Q8Mesh& mesh,
                              const plate::PlateRegions& regions) {
  if (!data.structure) return plate::dry_modes(mesh, regions, {.count = data.mode_count});
  if (data.structure->has_modes())
    return plate::dry_modes(mesh, data.structure->modes, data.mode_count);
  return plate::dry_modes(mesh, data.structure->matrices, {.count = data.mode_count});
}

// Of the direct route
plate::DryModes no_modes(const mesh::Q8Mesh& mesh) {
  plate::DryModes none;
  none.shape.resize(plate::kUnknownsPerNode * mesh.node_count(), 0);
  none.modal_mass.resize(0, 0);
  return none;
}

bool wants_section_forces(const Case& data) {
  return std::any_of(data.quantities.begin(), data.quantities.end(), response::is_section_force);
}

}  // namespace

void StageClock::add(const std::string& stage, std::chrono::duration<double> elapsed) {
  auto at = std::find_if(times_.begin(), times_.end(),
                         [&](const StageTime& time) { return time.stage == stage; });
  if (at == times_.end()) at = times_.insert(times_.end(), {stage, 0.0, 0.0});
  at->seconds += elapsed.count();
  at->peak_memory = numeric::peak_memory();
}

Estimate plan_of(const Case& data, const Meshes& meshes) {
  return estimate(data, meshes.fluid, meshes.own(), omp_get_max_threads());
}

Meshes prepare_meshes(const Case& data, Log& log) {
  mesh::MeshFile file = load_told(data.mesh, log);
  Meshes meshes{std::move(file.mesh), std::nullopt, data.plate};
  if (!data.plate_mesh.empty()) {
    file = load_told(data.plate_mesh.front(), log);
    meshes.own_plate = std::move(file.mesh);
  }
  meshes.regions = plate_regions(data, meshes.plate().element_count(), file.groups);

  // Refuse what is too coarse or too large before anything is computed
  const Preflight found = preflight(data, meshes.fluid, meshes.own(), &meshes.regions);
  for (const std::string& warning : found.warnings) log.warning(warning);
  require_resolution(data, found);
  require_fit(data, meshes.fluid, meshes.own(), meshes.regions);
  require_budget(plan_of(data, meshes),
                 numeric::memory_budget(data.memory_limit, numeric::memory_limits()));
  return meshes;
}

PlateModel prepare_plate(const Case& data, const Meshes& meshes,
                         std::optional<plate::DryModes> known) {
  const mesh::Q8Mesh& mesh = meshes.plate();
  const SparseMatrix at_points =
      response::interpolation_to(mesh, positions_of(data.points), names_of(data.points));
  const SparseMatrix at_lines = interpolation_to_lines(mesh, data.lines);
  const plate::PlateRegions& regions = meshes.regions;
  const bool direct = data.route == SolverRoute::kDirect;
  plate::DryModes modes = direct  ? no_modes(mesh)
                          : known ? std::move(*known)
                                  : compute_modes(data, mesh, regions);
  plate::DryModes fluid_modes =
      meshes.own_plate ? plate::interpolate_modes(modes, mesh, meshes.fluid) : modes;
  const std::vector<Index> elements =
      response::elements_at(mesh, positions_of(data.points), names_of(data.points));
  response::ModalBasis points(mesh, regions, modes, at_points, data.quantities, elements);
  response::ModalBasis lines(mesh, data.plate, modes, at_lines, {});
  std::optional<plate::StaticCorrection> correction;
  if (wants_section_forces(data) && !direct) correction.emplace(mesh, regions, modes);
  SparseMatrix from_plate;
  if (meshes.own_plate) from_plate = interpolation_to_nodes(mesh, meshes.fluid);
  std::optional<plate::PlateMatrices> matrices;
  if (direct) matrices = plate::assemble_plate(mesh, regions);
  return {regions,          std::move(modes),      std::move(fluid_modes), std::move(points),
          std::move(lines), std::move(correction), std::move(from_plate),  std::move(matrices)};
}

FluidModel prepare_fluid(const Case& data, const Meshes& meshes, const PlateModel& plate,
                         const SeaBand& band) {
  const mesh::Q8Mesh& mesh = meshes.fluid;
  FluidModel fluid{.operators = prepare_operators(data, mesh, std::max(data.omega.back(), band.to)),
                   .integrals = bem::ElementIntegrals(mesh),
                   .surface_mass = hydro::surface_mass(mesh),
                   .deflection = plate.fluid_modes.shape(
                       Eigen::seq(0, Eigen::last, plate::kUnknownsPerNode), Eigen::all),
                   .at_points = response::interpolation_to(mesh, positions_of(data.points),
                                                           names_of(data.points)),
                   .wave_points = positions_of(data.wave_points),
                   .heading = {},
                   .reach = 0.0,
                   .pause = {}};
  for (const double degrees : data.heading_deg)
    fluid.heading.push_back(degrees * std::numbers::pi / 180.0);

  // NOTE: from far away the exact function is evaluated: a table that reached there would be as
  // long as the way in wavelengths
  constexpr double kFar = 3.0;  // sizes of the mesh
  Point2 lower = mesh.lower(), upper = mesh.upper();
  const Point2 margin = Point2::Constant(kFar * (upper - lower).norm());
  for (Index i = 0; i < fluid.wave_points.cols(); ++i) {
    const Point2 point =
        fluid.wave_points.col(i).cwiseMax(mesh.lower() - margin).cwiseMin(mesh.upper() + margin);
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
  fluid.reach = 1.001 * (upper - lower).norm();
  for (const auto& plan : {fluid.operators.sums, fluid.operators.step_sums})
    if (plan) fluid.reach = std::max(fluid.reach, plan->reach());
  return fluid;
}

}  // namespace floe
