#include <floe/hydro/flexural_gravity.hpp>
#include <floe/mesh/point_locator.hpp>
#include <floe/numeric/error.hpp>
#include <floe/preflight.hpp>
#include <floe/response/stations.hpp>
#include <floe/wave/dispersion.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>

namespace floe {
namespace {

constexpr double kLargestAspect = 20.0;
constexpr double kLargestJump = 10.0;
constexpr double kLargestScale = 1e4;

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
  const Index least = 3 * mesh.piece_count(), most = 3 * mesh.node_count() / 2;
  FLOE_VALIDATE(
      data.mode_count >= least && data.mode_count <= most,
      "invalid modes.count = " << data.mode_count << " (must be " << least << " to " << most
                               << " for this mesh: three a plate, at most half the unknowns)");
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

Preflight preflight(const Case& data, const mesh::Q8Mesh& mesh, const mesh::Q8Mesh* plate_mesh) {
  Preflight found;
  found.quality = mesh::measure_quality(mesh);
  const double spacing = 0.5 * found.quality.longest_edge;
  const double plate_spacing =
      plate_mesh ? std::max(spacing, 0.5 * mesh::measure_quality(*plate_mesh).longest_edge)
                 : spacing;
  for (const double omega : data.omega) {
    const double wavelength = 2.0 * std::numbers::pi / wave::wavenumber(omega, data.water);
    const double flexural =
        2.0 * std::numbers::pi / hydro::flexural_wavenumber(omega, data.water, data.plate);
    found.resolution.push_back({.omega = omega,
                                .wavelength = wavelength,
                                .flexural_wavelength = flexural,
                                .nodes_per_wavelength = wavelength / spacing,
                                .nodes_per_flexural_wavelength = flexural / plate_spacing});
  }
  warn_about_shape(found.quality, found.warnings);
  warn_about_waves(found.resolution, mesh.size(), found.warnings);
  return found;
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

void require_fit(const Case& data, const mesh::Q8Mesh& mesh, const mesh::Q8Mesh* plate_mesh) {
  require_points(data, mesh);
  if (plate_mesh) {
    require_cover(*plate_mesh, mesh);
    require_points(data, *plate_mesh);
  }
  require_modes(data, plate_mesh ? *plate_mesh : mesh);
}

}  // namespace floe
