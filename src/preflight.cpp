#include <floe/bem/element_lattice.hpp>
#include <floe/hydro/flexural_gravity.hpp>
#include <floe/mesh/point_locator.hpp>
#include <floe/numeric/error.hpp>
#include <floe/preflight.hpp>
#include <floe/response/stations.hpp>
#include <floe/wave/dispersion.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace floe {
namespace {

constexpr double kLargestAspect = 20.0;
constexpr double kLargestJump = 10.0;
constexpr double kLargestScale = 1e4;

// A part of the plate with its own waves, and the distance of its nodes
struct Part {
  plate::PlateProperties properties;
  double spacing = 0.0;  // [m]
};

// The fluid's mesh and the plate's own both have to follow the waves along the plate, in each
// region those of the region
std::vector<Part> parts_of(const plate::PlateRegions& regions, const mesh::Q8Mesh& mesh,
                           const mesh::Q8Mesh* plate_mesh) {
  const mesh::Q8Mesh& own = plate_mesh ? *plate_mesh : mesh;
  const VecXd edges = mesh::longest_edges(own);
  const double fluid = plate_mesh ? mesh::longest_edges(mesh).maxCoeff() : 0.0;
  std::vector<double> longest(regions.count(), 0.0);
  for (Index e = 0; e < own.element_count(); ++e)
    longest[regions.region(e)] = std::max(longest[regions.region(e)], edges[e]);
  std::vector<Part> parts;
  for (int region = 0; region < regions.count(); ++region)
    if (longest[region] > 0.0)
      parts.push_back({regions[region], 0.5 * std::max(longest[region], fluid)});
  return parts;
}

// The same where it is not known which elements are of which region: each may be on the longest
std::vector<Part> parts_anywhere(const Case& data, const mesh::Q8Mesh& mesh,
                                 const mesh::Q8Mesh* plate_mesh) {
  std::vector<Part> parts = parts_of(data.plate, mesh, plate_mesh);
  for (const PlateRegion& region : data.regions)
    parts.push_back({region.properties, parts.front().spacing});
  return parts;
}

// Range of the frequencies below a bound: "omega = 1.2 … 2 rad/s (5 of 9 frequencies)"
std::string name_coarse(const std::vector<Resolution>& resolution, double bound, double& least) {
  double from = std::numeric_limits<double>::infinity(), to = 0.0;
  Index count = 0;
  for (const Resolution& r : resolution) {
    if (r.least_nodes() >= bound) continue;
    from = std::min(from, r.omega);
    to = std::max(to, r.omega);
    least = std::min(least, r.least_nodes());
    ++count;
  }
  if (count == 0) return "";
  const std::string range = from == to ? fmt::format("{}", from) : fmt::format("{} … {}", from, to);
  return fmt::format("omega = {} rad/s ({} of {} frequencies)", range, count, resolution.size());
}

void warn_about_shape(const mesh::MeshQuality& quality, std::vector<std::string>& warnings) {
  if (quality.worst_aspect_ratio > kLargestAspect)
    warnings.push_back(
        fmt::format("slender elements: aspect ratio = {:.3g} in element {} (up to {} is good)",
                    quality.worst_aspect_ratio, quality.worst_aspect_element, kLargestAspect));
  if (quality.largest_edge_jump > kLargestJump)
    warnings.push_back(
        fmt::format("uneven mesh: neighbouring elements {} and {} differ in size by a factor of "
                    "{:.3g} (up to {} is good)",
                    quality.edge_jump_element, quality.edge_jump_neighbour,
                    quality.largest_edge_jump, kLargestJump));
}

// A plate's theory holds for what is thin
void warn_about_thickness(const Case& data, const mesh::Q8Mesh& mesh,
                          std::vector<std::string>& warnings) {
  constexpr double kThickest = 0.2;  // of the shorter side
  if (data.structure) return;
  const double side = (mesh.upper() - mesh.lower()).minCoeff();
  double thickest = data.plate.thickness;
  for (const PlateRegion& region : data.regions)
    thickest = std::max(thickest, region.properties.thickness);
  if (thickest > kThickest * side)
    warnings.push_back(
        fmt::format("thick plate: thickness = {:.4g} m, shorter side = {:.4g} m (up to {:g} of it "
                    "is good; are thickness and mesh in metres?)",
                    thickest, side, kThickest));
}

void warn_about_waves(const std::vector<Resolution>& resolution, double size,
                      std::vector<std::string>& warnings) {
  double least = std::numeric_limits<double>::infinity();
  const std::string coarse = name_coarse(resolution, kNodesWanted, least);
  if (!coarse.empty())
    warnings.push_back(
        fmt::format("coarse mesh: {:.2g} nodes per wavelength at {} ({} or more are good)", least,
                    coarse, kNodesWanted));
  for (const Resolution& r : resolution) {
    const double scale = std::max(size / r.wavelength, r.wavelength / size);
    if (scale <= kLargestScale) continue;
    warnings.push_back(
        fmt::format("mesh size = {:.3g} m and wavelength = {:.3g} m differ by more than {:g} (is "
                    "the mesh in metres?)",
                    size, r.wavelength, kLargestScale));
    break;
  }
}

// A plate has about area·k²/4π elastic modes below the wavenumber k of its waves; a converged
// answer takes about four times as many
std::string tell_few_modes(const Case& data, const mesh::Q8Mesh& mesh, double shortest) {
  constexpr double kTimesBelow = 4.0;
  if (data.route == SolverRoute::kDirect) return "";
  const double k = 2.0 * std::numbers::pi / shortest;
  const double below = mesh.area() * k * k / (4.0 * std::numbers::pi);
  const double wanted = 3.0 * static_cast<double>(mesh.piece_count()) + kTimesBelow * below;
  if (static_cast<double>(data.mode_count) >= wanted || below < 0.5) return "";
  return fmt::format(
      "few modes: modes.count = {}, about {:.0f} elastic modes are longer than the shortest wave "
      "along the plate, {:.3g} m (modes.count = {:.0f} is good, or solver.route = \"direct\")",
      data.mode_count, below, shortest, std::ceil(wanted));
}

// The points and the stations of the lines lie on the mesh
void require_points(const Case& data, const mesh::Q8Mesh& mesh) {
  std::vector<std::string> names, places;
  std::vector<Point2> positions;
  for (const NamedPoint& point : data.points) {
    names.push_back(point.name);
    places.push_back(point.place);
    positions.push_back(point.position);
  }
  for (const NamedLine& line : data.lines) {
    const Points2 stations = response::line_stations(line.from, line.to, line.count);
    for (int i = 0; i < line.count; ++i) {
      names.push_back(fmt::format("{} of line {}", i + 1, line.name));
      places.push_back(line.place);
      positions.emplace_back(stations.col(i));
    }
  }
  const mesh::PointLocator locator(mesh);
  for (std::size_t i = 0; i < positions.size(); ++i)
    FLOE_VALIDATE(locator.locate(positions[i]).has_value(),
                  places[i] << response::point_off_plates(mesh, positions[i], names[i]));
}

void require_modes(const Case& data, const mesh::Q8Mesh& mesh) {
  if (data.route == SolverRoute::kDirect) return;
  const Index least = 3 * mesh.piece_count(), most = 3 * mesh.node_count() / 2;
  FLOE_VALIDATE(
      data.mode_count >= least && data.mode_count <= most,
      "invalid modes.count = " << data.mode_count << " (must be " << least << " to " << most
                               << " for this mesh: three a plate, at most half the unknowns)");
}

void require_structure(const Case& data, const mesh::Q8Mesh& mesh) {
  if (!data.structure) return;
  if (data.structure->has_modes())
    plate::check_modes(mesh, data.structure->modes);
  else
    plate::check_matrices(mesh, data.structure->matrices);
}

// The direct route's compliance is that of a plate which its own inertia does not lift
void require_light(const Case& data, const plate::PlateRegions& regions) {
  if (data.route != SolverRoute::kDirect) return;
  const std::vector<Index> count = regions.element_counts();
  double heaviest = 0.0;
  for (int region = 0; region < regions.count(); ++region)
    if (count[region] > 0) heaviest = std::max(heaviest, regions[region].surface_mass());
  const double omega = data.omega.back(), weight = data.water.density * data.water.gravity;
  FLOE_VALIDATE(heaviest * omega * omega < weight,
                "invalid omega = " << omega << " rad/s (must be below "
                                   << std::sqrt(weight / heaviest)
                                   << " for solver.route = direct, where the plate's inertia "
                                      "outweighs the water's stiffness)");
}

void require_cover(const mesh::Q8Mesh& plate, const mesh::Q8Mesh& fluid) {
  const mesh::PointLocator locator(plate);
  for (Index node = 0; node < fluid.node_count(); ++node) {
    const Point2 at = fluid.nodes().col(node);
    FLOE_VALIDATE_AS(MeshError, locator.locate(at).has_value(),
                     "invalid plate.mesh: node " << node + 1 << " of [mesh] at [" << at.x() << ", "
                                                 << at.y()
                                                 << "] m lies outside (must cover all of [mesh])");
  }
}

}  // namespace

Preflight preflight(const Case& data, const mesh::Q8Mesh& mesh, const mesh::Q8Mesh* plate_mesh,
                    const plate::PlateRegions* regions) {
  Preflight found;
  found.quality = mesh::measure_quality(mesh);
  const double spacing = 0.5 * found.quality.longest_edge;
  std::vector<Part> parts;  // NOTE: none of a structure that another program has made
  if (!data.structure)
    parts = regions ? parts_of(*regions, mesh, plate_mesh) : parts_anywhere(data, mesh, plate_mesh);
  for (const double omega : data.omega) {
    const double wavelength = 2.0 * std::numbers::pi / wave::wavenumber(omega, data.water);
    Resolution resolution;
    resolution.omega = omega;
    resolution.wavelength = wavelength;
    resolution.nodes_per_wavelength = wavelength / spacing;
    for (const Part& part : parts) {
      const double flexural =
          2.0 * std::numbers::pi / hydro::flexural_wavenumber(omega, data.water, part.properties);
      if (flexural / part.spacing >= resolution.nodes_per_flexural_wavelength) continue;
      resolution.flexural_wavelength = flexural;
      resolution.nodes_per_flexural_wavelength = flexural / part.spacing;
    }
    found.resolution.push_back(resolution);
  }
  warn_about_shape(found.quality, found.warnings);
  warn_about_thickness(data, mesh, found.warnings);
  warn_about_waves(found.resolution, mesh.size(), found.warnings);
  double shortest = std::numeric_limits<double>::infinity();
  for (const Resolution& r : found.resolution) shortest = std::min(shortest, r.flexural_wavelength);
  found.few_modes = tell_few_modes(data, mesh, shortest);
  if (!found.few_modes.empty()) found.warnings.push_back(found.few_modes);
  return found;
}

std::vector<Resolution> sea_resolution(const Case& data,
                                       const std::vector<SolvedSeaFrequency>& solved,
                                       const mesh::Q8Mesh& mesh, const mesh::Q8Mesh* plate_mesh,
                                       const plate::PlateRegions* regions) {
  if (solved.empty()) return {};
  Case seas = data;
  seas.omega.clear();
  for (const SolvedSeaFrequency& one : solved) seas.omega.push_back(one.report.omega);
  return preflight(seas, mesh, plate_mesh, regions).resolution;
}

void require_resolution(const Case& data, const Preflight& found) {
  double least = std::numeric_limits<double>::infinity();
  const std::string hopeless = name_coarse(found.resolution, kNodesAtLeast, least);
  FLOE_VALIDATE(
      hopeless.empty(),
      "invalid mesh resolution = " << fmt::format("{:.2g}", least) << " nodes per wavelength at "
                                   << hopeless << " (must be at least " << kNodesAtLeast
                                   << ", even with --allow-coarse; are mesh and depth in metres?)");
  const std::string coarse = name_coarse(found.resolution, kNodesRequired, least);
  FLOE_VALIDATE(coarse.empty() || data.allow_coarse,
                "invalid mesh resolution = " << fmt::format("{:.2g}", least)
                                             << " nodes per wavelength at " << coarse
                                             << " (must be at least " << kNodesRequired
                                             << "; refine the mesh, lower the frequencies or give "
                                                "--allow-coarse)");
}

void require_fit(const Case& data, const mesh::Q8Mesh& mesh, const mesh::Q8Mesh* plate_mesh,
                 const plate::PlateRegions& regions) {
  require_points(data, mesh);
  require_light(data, regions);
  if (plate_mesh) {
    require_cover(*plate_mesh, mesh);
    require_points(data, *plate_mesh);
  }
  require_modes(data, plate_mesh ? *plate_mesh : mesh);
  require_structure(data, plate_mesh ? *plate_mesh : mesh);
  if (data.method == SolverMethod::kLattice) bem::require_element_lattice(mesh);
}

}  // namespace floe
