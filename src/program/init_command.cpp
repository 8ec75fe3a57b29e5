#include "program/commands.hpp"

#include <floe/io/case_template.hpp>
#include <floe/numeric/error.hpp>
#include <floe/preflight.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace floe::program {
namespace {

// Elements short enough for four across the plate and for waves of 5 s
mesh::RectangleOptions elements_for(double length, double width) {
  const double edge = std::min(6.0, std::min(length, width) / 4.0);
  return {.length = length,
          .width = width,
          .nx = static_cast<int>(std::lround(std::ceil(length / edge - 1e-9))),
          .ny = static_cast<int>(std::lround(std::ceil(width / edge - 1e-9)))};
}

// Nodes that reach farthest towards the corners of the bounding box, and the one nearest to its
// centre: P1 … P5 as in the paper
std::vector<NamedPoint> telling_points(const mesh::Q8Mesh& mesh) {
  const Point2 centre = 0.5 * (mesh.lower() + mesh.upper());
  const Point2 half = 0.5 * (mesh.upper() - mesh.lower());
  const double corners[][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}, {0.0, 0.0}};
  std::vector<NamedPoint> points;
  for (const auto& [cx, cy] : corners) {
    const Point2 wanted(cx, cy);
    Index best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (Index node = 0; node < mesh.node_count(); ++node) {
      const Point2 place = (mesh.nodes().col(node) - centre).cwiseQuotient(half);
      const double distance = (place - wanted).norm();
      if (distance >= least - 1e-12) continue;
      least = distance;
      best = node;
    }
    points.push_back({fmt::format("P{}", points.size() + 1), mesh.nodes().col(best)});
  }
  return points;
}

// The highest frequency, at most 1.6 rad/s, whose waves have 6 nodes or more
double highest_frequency(const Case& data, const mesh::Q8Mesh& mesh) {
  double highest = 0.0;
  for (const Resolution& r : preflight(data, mesh).resolution)
    if (r.least_nodes() >= 6.0) highest = std::max(highest, r.omega);
  return highest;
}

std::string title_of(const std::filesystem::path& case_file) {
  std::string title = case_file.stem().string();
  std::replace(title.begin(), title.end(), '_', ' ');
  return title;
}

}  // namespace

void make_new_case(const InitOptions& options) {
  // Make or read the mesh
  io::CaseTemplate wanted;
  wanted.title = title_of(options.case_file);
  wanted.depth = options.depth;
  wanted.thickness = options.thickness;
  wanted.heading_deg = options.heading_deg;
  if (options.mesh.empty()) {
    wanted.rectangle = elements_for(options.length, options.width);
  } else {
    const auto folder = std::filesystem::absolute(options.case_file).parent_path();
    wanted.mesh_file = std::filesystem::absolute(options.mesh).lexically_relative(folder).string();
  }
  const mesh::MeshFile file =
      load_mesh(options.mesh.empty() ? MeshSource(wanted.rectangle) : MeshSource(options.mesh));

  // Choose waves that it resolves, and points on it
  Case data;
  data.mode_count = std::max(30, 6 * file.mesh.piece_count());  // of all plates
  data.water.depth = options.depth;
  data.plate = {.thickness = options.thickness,
                .youngs_modulus = 1.19e10,
                .poisson_ratio = 0.13,
                .density = 256.25};
  for (int i = 3; i <= 16; ++i) data.omega.push_back(0.1 * i);
  wanted.omega_from = 0.2;
  wanted.omega_to = std::max(0.3, highest_frequency(data, file.mesh));
  wanted.points = telling_points(file.mesh);
  wanted.mode_count = data.mode_count;
  if (!options.sea.empty()) wanted.sea = {options.sea[0], options.sea[1]};

  io::write_new_case(options.case_file, wanted);
  print(fmt::format("{0}: {1}, {2}; edit [plate], then\n  floe check {0}\n  floe run {0}\n",
                    options.case_file.string(), counted(file.mesh.node_count(), "node"),
                    counted(file.mesh.element_count(), "element")));
}

}  // namespace floe::program
