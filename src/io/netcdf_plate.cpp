#include "io/netcdf_parts.hpp"

#include <floe/plate/mindlin.hpp>
#include <floe/response/stations.hpp>

#include <cmath>
#include <numbers>

namespace floe::io {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

void add_positions(NetcdfFile& file, const std::string& name, const std::string& dimension,
                   const Points2& points, const std::string& long_name) {
  std::vector<double> values;
  for (Index i = 0; i < points.cols(); ++i)
    values.insert(values.end(), {points(0, i), points(1, i), 0.0});
  file.add_numbers(name, {dimension, "space_coordinate"}, values, Compression::kDeflate);
  describe(file, name, long_name, "m");
}

// Nodes and elements of a mesh; the nodes' dimension is `node`
void add_mesh(NetcdfFile& file, const mesh::Q8Mesh& mesh, const std::string& node,
              const std::string& element, const std::string& which) {
  file.add_dimension(node, static_cast<std::size_t>(mesh.node_count()));
  file.add_dimension(element, static_cast<std::size_t>(mesh.element_count()));
  add_positions(file, node + "_coordinates", node, mesh.nodes(), "Nodes of " + which);
  std::vector<int> corners;
  for (Index i = 0; i < mesh.elements().size(); ++i)
    corners.push_back(static_cast<int>(mesh.elements()(i)));
  file.add_integers(element + "_nodes", {element, "element_corner"}, corners);
  describe(file, element + "_nodes", "Nodes of each element, from 0", "",
           "quadratic quadrilaterals: corners counter-clockwise, then the middles of the sides");
}

bool has_own_mesh(const StoredRun& run) { return !run.data().plate_mesh.empty(); }

// Where the pressures and node fields of the fluid live
std::string fluid_node(const StoredRun& run) { return has_own_mesh(run) ? "fluid_node" : "node"; }

void add_shapes(NetcdfFile& file, const plate::DryModes& modes, const plate::BodyDofs& dofs) {
  const auto nodes = static_cast<std::size_t>(modes.shape.rows() / plate::kUnknownsPerNode);
  file.define_parts("mode_shape", {"influenced_dof", "node", "displacement"}, 1);
  for (Index j = 0; j < dofs.count(); ++j) {
    const VecXd shape = modes.shape * dofs.motion.col(j);
    file.put_part("mode_shape", {static_cast<std::size_t>(j), 0, 0}, {1, nodes, 3},
                  std::span(shape.data(), static_cast<std::size_t>(shape.size())));
  }
  describe(file, "mode_shape", "Shapes of the degrees of freedom", "",
           "deflection everywhere = sum over influenced_dof of RAO times mode_shape; w in m, "
           "rotations in rad, by unit of the degree of freedom (m, rad, kg^(1/2) m)");
}

// What is known at every frequency and heading: rows × headings each
void add_rao(NetcdfFile& file, const std::string& name, const std::string& dimension,
             const std::vector<MatXcd>& values, const std::string& long_name) {
  if (values.empty() || values.front().rows() == 0) return;
  file.add_numbers(name, {"complex", "omega", "wave_direction", dimension}, split_complex(values));
  describe(file, name, long_name, "m/m");
}

std::vector<std::string> names_of(const std::vector<NamedPoint>& points) {
  std::vector<std::string> names;
  for (const NamedPoint& point : points) names.push_back(point.name);
  return names;
}

void add_points(NetcdfFile& file, const std::vector<NamedPoint>& points, const std::string& name,
                const std::string& long_name) {
  if (points.empty()) return;
  add_axis(file, name, names_of(points), long_name);
  Points2 positions(2, static_cast<Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    positions.col(static_cast<Index>(i)) = points[i].position;
  add_positions(file, name + "_coordinates", name, positions, long_name + ": position");
}

void add_stations(NetcdfFile& file, const std::vector<NamedLine>& lines) {
  std::vector<std::string> names;
  std::vector<double> positions;
  for (const NamedLine& line : lines) {
    const Points2 stations = response::line_stations(line.from, line.to, line.count);
    names.insert(names.end(), static_cast<std::size_t>(line.count), line.name);
    positions.insert(positions.end(), stations.data(), stations.data() + stations.size());
  }
  if (names.empty()) return;
  file.add_dimension("station", names.size());
  file.add_texts("station_line", {"station"}, names);
  describe(file, "station_line", "Line of each station");
  add_positions(file, "station_coordinates", "station",
                Eigen::Map<const Points2>(positions.data(), 2, static_cast<Index>(names.size())),
                "Stations of all lines");
}

// Quantities at the points, quantity outside point
void add_quantities(NetcdfFile& file, const Case& data, const std::vector<FrequencyResult>& all) {
  if (data.points.empty() || data.quantities.empty()) return;
  std::vector<std::string> names, units;
  for (const response::Quantity quantity : data.quantities) {
    names.emplace_back(response::name(quantity));
    units.emplace_back(response::unit(quantity));
  }
  add_axis(file, "quantity", names, "Quantity at points");
  file.add_texts("quantity_units", {"quantity"}, units);
  describe(file, "quantity_units", "Unit of each quantity");
  std::vector<MatXcd> values;
  for (const FrequencyResult& result : all) {
    const Index points = result.point_quantities.front().rows();
    MatXcd stacked(points * static_cast<Index>(data.quantities.size()),
                   result.point_quantities.front().cols());
    for (std::size_t q = 0; q < data.quantities.size(); ++q)
      stacked.middleRows(points * static_cast<Index>(q), points) = result.point_quantities[q];
    values.push_back(std::move(stacked));
  }
  file.add_numbers("point_rao", {"complex", "omega", "wave_direction", "quantity", "point"},
                   split_complex(values));
  describe(file, "point_rao", "Quantities at points", "", "quantity_units per metre of wave");
}

// Node fields one by one: a list, since they are kept for the waves asked for only
class FieldWriter {
 public:
  FieldWriter(NetcdfFile& file, const std::string& node) : file_(file) {
    for (const auto& [name, units, words] :
         {std::tuple{"deflection_rao", "m/m", "Deflection at the nodes, positive up"},
          std::tuple{"pressure_rao", "Pa/m", "Total pressure at the nodes, positive pushes up"}}) {
      file_.define_parts(name, {"complex", "field", node}, 2);
      describe(file_, name, words, units);
    }
  }
  void add(const NodeField& field) {
    put("deflection_rao", field.deflection);
    put("pressure_rao", field.pressure);
    ++count_;
  }

 private:
  void put(const std::string& name, const VecXcd& values) {
    const auto nodes = static_cast<std::size_t>(values.size());
    const VecXd real = values.real(), imaginary = values.imag();
    file_.put_part(name, {0, count_, 0}, {1, 1, nodes}, std::span(real.data(), nodes));
    file_.put_part(name, {1, count_, 0}, {1, 1, nodes}, std::span(imaginary.data(), nodes));
  }
  NetcdfFile& file_;  // borrowed
  std::size_t count_ = 0;
};

}  // namespace

void add_plate(NetcdfFile& file, const StoredRun& run, const BodyResults& results) {
  const plate::DryModes modes = run.modes();
  std::vector<double> frequencies;
  for (Index j = 0; j < results.dofs.count(); ++j)
    frequencies.push_back(std::sqrt(results.dofs.stiffness[j]));
  file.add_numbers("mode_frequency", {"influenced_dof"}, frequencies);
  describe(file, "mode_frequency", "Natural frequency of the dry plate, 0 for rigid motions",
           "rad/s");
  file.add_dimension("element_corner", 8);
  add_axis(file, "displacement", {"w", "rotation_x", "rotation_y"}, "Displacement");
  add_mesh(file, run.mode_mesh(), "node", "element", "the plate");
  if (has_own_mesh(run))
    add_mesh(file, run.fluid_mesh(), "fluid_node", "fluid_element", "the fluid");
  add_shapes(file, modes, results.dofs);
}

void add_places(NetcdfFile& file, const StoredRun& run, const BodyResults& results) {
  // Everything but node fields fits into memory
  const Case& data = run.data();
  std::vector<FrequencyResult> all;
  std::vector<double> field_omega, field_direction;
  for (std::size_t i = 0; i < data.omega.size(); ++i)
    if (std::optional<FrequencyResult> result = run.tried_frequency(i, results.dofs.count())) {
      for (const NodeField& field : result->fields) {
        field_omega.push_back(field.omega);
        field_direction.push_back(kDegree * field.heading_deg);
      }
      result->fields.clear();
      all.push_back(std::move(*result));
    }

  add_points(file, data.points, "point", "Points on the plate");
  add_points(file, data.wave_points, "wave_point", "Points on the water");
  add_stations(file, data.lines);
  add_quantities(file, data, all);
  std::vector<MatXcd> lines, waves;
  for (const FrequencyResult& result : all) {
    lines.push_back(result.line_deflection);
    waves.push_back(result.wave_elevation);
  }
  add_rao(file, "line_deflection_rao", "station", lines, "Deflection along lines, positive up");
  add_rao(file, "wave_elevation_rao", "wave_point", waves,
          "Elevation of the whole wave: incident, scattered and radiated");

  if (field_omega.empty()) return;
  file.add_dimension("field", field_omega.size());
  file.add_numbers("field_omega", {"field"}, field_omega);
  describe(file, "field_omega", "Angular frequency of each node field", "rad/s");
  file.add_numbers("field_wave_direction", {"field"}, field_direction);
  describe(file, "field_wave_direction", "Wave direction of each node field", "rad");
  FieldWriter writer(file, fluid_node(run));
  for (std::size_t i = 0; i < data.omega.size(); ++i)
    if (run.has_frequency(i)) {
      const FrequencyResult result = run.frequency(i);
      for (const NodeField& field : result.fields) writer.add(field);
    }
}

}  // namespace floe::io
