#include "program/commands.hpp"

#include <floe/bem/element_lattice.hpp>
#include <floe/disk_estimate.hpp>
#include <floe/estimate.hpp>
#include <floe/numeric/memory.hpp>
#include <floe/preflight.hpp>
#include <floe/sea_band.hpp>

#include <fmt/format.h>
#include <omp.h>

#include <optional>
#include <vector>

namespace floe::program {
namespace {

void tell_mesh(const std::string& name, const mesh::MeshFile& file,
               const mesh::MeshQuality& quality, Account& account) {
  const mesh::Q8Mesh& mesh = file.mesh;
  account.fact(name, fmt::format("{}, {}, {}, {:.6g} m²", counted(mesh.node_count(), "node"),
                                 counted(mesh.element_count(), "element"),
                                 counted(mesh.piece_count(), "piece"), mesh.area()));
  account.fact("", fmt::format("x {:.6g} … {:.6g} m, y {:.6g} … {:.6g} m", mesh.lower().x(),
                               mesh.upper().x(), mesh.lower().y(), mesh.upper().y()));
  account.fact("", fmt::format("edges {:.4g} … {:.4g} m, aspect ratio up to {:.3g}, neighbours "
                               "differ by up to {:.3g}",
                               quality.shortest_edge, quality.longest_edge,
                               quality.worst_aspect_ratio, quality.largest_edge_jump));
  for (const std::string& notice : file.notices) account.notice(notice);
}

void tell_resolution(const Preflight& found, Account& account) {
  account.info(
      "\n   omega  wavelength    nodes per  flexural wave    nodes per\n"
      "   rad/s           m   wavelength              m   wavelength");
  for (const Resolution& r : found.resolution)
    account.info(fmt::format("{:8.4g}  {:10.4g}  {:11.3g}  {:13.4g}  {:11.3g}{}", r.omega,
                             r.wavelength, r.nodes_per_wavelength, r.flexural_wavelength,
                             r.nodes_per_flexural_wavelength,
                             r.least_nodes() < kNodesRequired ? "  too coarse"
                             : r.least_nodes() < kNodesWanted ? "  coarse"
                                                              : ""));
  account.info("");
}

// What the methods that were not chosen would need, and the other route, which knows no seas
std::vector<Estimate> estimate_others(const Case& data, const mesh::Q8Mesh& mesh,
                                      const mesh::Q8Mesh* plate_mesh, const Estimate& chosen) {
  std::vector<Estimate> others;
  for (const SolverMethod method :
       {SolverMethod::kDense, SolverMethod::kLattice, SolverMethod::kPfft, SolverMethod::kFmm}) {
    if (method_name(method) == chosen.method) continue;
    if (method == SolverMethod::kLattice && !bem::find_element_lattice(mesh)) continue;
    Case other = data;
    other.method = method;
    others.push_back(estimate(other, mesh, plate_mesh, omp_get_max_threads()));
  }
  if (!data.seas.empty() || (data.sea_grid.from && data.sea_grid.to)) return others;
  Case other = data;
  other.route = data.route == SolverRoute::kModal ? SolverRoute::kDirect : SolverRoute::kModal;
  others.push_back(estimate(other, mesh, plate_mesh, omp_get_max_threads()));
  return others;
}

void tell_needs(const Estimate& needed, const std::vector<Estimate>& others, double budget,
                double disk, Account& account) {
  account.fact("method", fmt::format("{}, {} route", needed.method, needed.route));
  for (const StageEstimate& stage : needed.stages)
    account.fact("", fmt::format("{:<12} {:>8}  about {}", stage.stage, format_bytes(stage.memory),
                                 format_duration(stage.seconds)));
  for (const Estimate& other : others)
    account.fact("", fmt::format("by {:<9} {:>8}  about {}{}",
                                 other.route == needed.route ? other.method : other.route,
                                 format_bytes(other.memory), format_duration(other.seconds),
                                 other.route == needed.route            ? ""
                                 : other.seconds < 0.8 * needed.seconds ? ": the cheaper route"
                                                                        : ""));
  account.fact("memory",
               fmt::format("{} of {}", format_bytes(needed.memory), format_bytes(budget)));
  account.fact("disk", format_bytes(disk));
  account.fact("time", fmt::format("about {} on {}", format_duration(needed.seconds),
                                   counted(omp_get_max_threads(), "thread")));
}

}  // namespace

void check_case(const RunOptions& options) {
  // Read the case and its meshes
  Account account(options.progress);
  const Case data = read_case_for(options, account);
  use_threads(options.threads, account);
  const mesh::MeshFile fluid = load_mesh(data.mesh);
  std::optional<mesh::MeshFile> plate;
  if (!data.plate_mesh.empty()) plate = load_mesh(data.plate_mesh.front());

  // Tell what was found
  const mesh::Q8Mesh* const own = plate ? &plate->mesh : nullptr;
  const mesh::MeshFile& of_plate = plate ? *plate : fluid;
  const plate::PlateRegions regions =
      plate_regions(data, of_plate.mesh.element_count(), of_plate.groups);
  const Preflight found = preflight(data, fluid.mesh, own, &regions);
  const Estimate needed = estimate(data, fluid.mesh, own, omp_get_max_threads());
  const double budget = numeric::memory_budget(data.memory_limit, numeric::memory_limits());
  tell_mesh("mesh", fluid, found.quality, account);
  if (plate) tell_mesh("plate mesh", *plate, mesh::measure_quality(plate->mesh), account);
  tell_resolution(found, account);
  tell_needs(needed, estimate_others(data, fluid.mesh, own, needed), budget,
             estimate_disk(data, fluid.mesh), account);
  for (const std::string& warning : found.warnings) account.warning(warning);
  account.show_warnings();

  // Refuse what a run would refuse
  require_fit(data, fluid.mesh, own, regions);
  require_resolution(data, found);
  require_budget(needed, budget);
  const SeaBand band = prepare_seas(data, fluid.mesh, own, regions, account);
  account.show_warnings();
  if (band.asked())
    account.fact("seas", fmt::format("frequencies {:.4g} … {:.4g} rad/s", band.from, band.to));
}

}  // namespace floe::program
