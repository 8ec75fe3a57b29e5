#include <floe/hydro/flexural_gravity.hpp>
#include <floe/numeric/error.hpp>
#include <floe/preflight.hpp>
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

void warn_about_shape(const MeshQuality& quality, std::vector<std::string>& warnings) {
  if (quality.largest_aspect > kLargestAspect)
    warnings.push_back(fmt::format("slender elements: aspect ratio = {:.3g} (up to {} is good)",
                                   quality.largest_aspect, kLargestAspect));
  if (quality.largest_jump > kLargestJump)
    warnings.push_back(
        fmt::format("uneven mesh: neighbouring elements differ in edge length by a factor of "
                    "{:.3g} (up to {} is good)",
                    quality.largest_jump, kLargestJump));
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

}  // namespace

MeshQuality mesh_quality(const mesh::Q8Mesh& mesh) {
  MeshQuality quality;
  quality.shortest_edge = std::numeric_limits<double>::infinity();
  VecXd longest_at_node = VecXd::Zero(mesh.node_count());
  VecXd shortest_at_node = VecXd::Constant(mesh.node_count(), quality.shortest_edge);
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const auto node = mesh.elements().col(e);
    double shortest = std::numeric_limits<double>::infinity(), longest = 0.0;
    for (int a = 0; a < 4; ++a) {
      const double edge = (mesh.nodes().col(node[a]) - mesh.nodes().col(node[(a + 1) % 4])).norm();
      shortest = std::min(shortest, edge);
      longest = std::max(longest, edge);
    }
    quality.shortest_edge = std::min(quality.shortest_edge, shortest);
    quality.longest_edge = std::max(quality.longest_edge, longest);
    quality.largest_aspect = std::max(quality.largest_aspect, longest / shortest);
    for (int a = 0; a < 8; ++a) {
      longest_at_node[node[a]] = std::max(longest_at_node[node[a]], longest);
      shortest_at_node[node[a]] = std::min(shortest_at_node[node[a]], longest);
    }
  }
  quality.largest_jump = longest_at_node.cwiseQuotient(shortest_at_node).maxCoeff();
  return quality;
}

Preflight preflight(const Case& data, const mesh::Q8Mesh& mesh, const mesh::Q8Mesh* plate_mesh) {
  Preflight found;
  found.quality = mesh_quality(mesh);
  const double spacing = 0.5 * found.quality.longest_edge;
  const double plate_spacing =
      plate_mesh ? std::max(spacing, 0.5 * mesh_quality(*plate_mesh).longest_edge) : spacing;
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
  const std::string coarse = name_coarse(found.resolution, kNodesRequired, least);
  FLOE_VALIDATE(coarse.empty() || data.allow_coarse,
                "invalid mesh resolution = " << fmt::format("{:.2g}", least)
                                             << " nodes per wavelength at " << coarse
                                             << " (must be at least " << kNodesRequired
                                             << "; refine the mesh, lower the frequencies or give "
                                                "--allow-coarse)");
}

}  // namespace floe
