#include "io/case_json.hpp"

#include <floe/estimate.hpp>
#include <floe/numeric/error.hpp>

#include <cmath>
#include <limits>

namespace floe::io {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Point2& point) { return Json::array({point.x(), point.y()}); }

Json shape_json(const std::filesystem::path& file) { return {{"file", file.string()}}; }

Json shape_json(const mesh::RectangleOptions& r) {
  return {{"rectangle",
           {{"length", r.length},
            {"width", r.width},
            {"nx", r.nx},
            {"ny", r.ny},
            {"grading", r.grading}}}};
}

template <typename Shape>
Json shape_json(const Shape& shape) {
  const mesh::ShapeKeys<Shape> keys = mesh::shape_keys(shape);
  Json sizes;
  for (const auto& length : keys.lengths) sizes[length.key] = shape.*length.member;
  for (const auto& count : keys.counts) sizes[count.key] = shape.*count.member;
  return {{keys.name, sizes}};
}

Json json_of(const MeshSource& source) {
  return std::visit([](const auto& shape) { return shape_json(shape); }, source);
}

Json json_of(const std::vector<NamedPoint>& points) {
  Json named = Json::object();
  for (const NamedPoint& point : points) named[point.name] = json_of(point.position);
  return named;
}

Json json_of(const PointQuantity& of) { return Json::array({of.point, of.quantity}); }

// Points and quantities by their places in the lists beside
Json relations_json(const SeaRelations& relations) {
  Json pairs = Json::array(), combinations = Json::array();
  for (const QuantityPair& pair : relations.pairs)
    pairs.push_back({json_of(pair.first), json_of(pair.second)});
  for (const Combination& combination : relations.combinations) {
    Json terms = Json::array();
    for (const CombinationTerm& term : combination.terms)
      terms.push_back({{"of", json_of(term.of)}, {"factor", term.factor}});
    combinations.push_back(
        {{"name", combination.name},
         {"kind", combination.kind == Combination::Kind::kSum ? "sum" : "von_mises"},
         {"terms", terms}});
  }
  return {{"cross_spectra", pairs}, {"combinations", combinations}};
}

Json output_json(const Case& data) {
  Json lines = Json::object(), quantities = Json::array(), fields = Json::array();
  for (const NamedLine& line : data.lines)
    lines[line.name] = {
        {"from", json_of(line.from)}, {"to", json_of(line.to)}, {"count", line.count}};
  for (const response::Quantity quantity : data.quantities)
    quantities.push_back(response::name(quantity));
  for (const FieldRequest& field : data.fields)
    fields.push_back({{"omega", field.omega}, {"heading_deg", field.heading_deg}});
  return {{"points", json_of(data.points)},
          {"lines", lines},
          {"wave_points", json_of(data.wave_points)},
          {"quantities", quantities},
          {"relations", relations_json(data.relations)},
          {"node_spectra", data.node_spectra},
          {"fields", fields}};
}

Json sea_grid_json(const Case& data) {
  Json grid = {{"tolerance", data.sea_grid.tolerance}};
  if (data.sea_grid.from) grid["from"] = *data.sea_grid.from;
  if (data.sea_grid.to) grid["to"] = *data.sea_grid.to;
  return grid;
}

Json seas_json(const Case& data) {
  Json seas = Json::array();
  for (const wave::SeaState& sea : data.seas)
    seas.push_back({{"name", sea.name},
                    {"description", sea.description},
                    {"significant_height", 4.0 * std::sqrt(sea.m0())},
                    {"mean_heading_deg", sea.mean_heading_deg},
                    {"duration", sea.duration},
                    {"allow_truncation", sea.allow_truncation}});
  return seas;
}

Point2 point_from(const Json& json) { return {json.at(0).get<double>(), json.at(1).get<double>()}; }

template <typename Shape>
MeshSource shape_from(const Json& json) {
  Shape shape;
  const mesh::ShapeKeys<Shape> keys = mesh::shape_keys(shape);
  const Json& sizes = json.at(keys.name);
  for (const auto& length : keys.lengths) sizes.at(length.key).get_to(shape.*length.member);
  for (const auto& count : keys.counts) sizes.at(count.key).get_to(shape.*count.member);
  return shape;
}

MeshSource mesh_source_from(const Json& json) {
  if (json.contains("file")) return std::filesystem::path(json.at("file").get<std::string>());
  if (json.contains("disc")) return shape_from<mesh::DiscOptions>(json);
  if (json.contains("ring")) return shape_from<mesh::RingOptions>(json);
  if (json.contains("lshape")) return shape_from<mesh::LShapeOptions>(json);
  if (json.contains("modules")) return shape_from<mesh::ModuleArrayOptions>(json);
  const Json& r = json.at("rectangle");
  return mesh::RectangleOptions{.length = r.at("length"),
                                .width = r.at("width"),
                                .nx = r.at("nx"),
                                .ny = r.at("ny"),
                                .grading = r.at("grading")};
}

std::vector<NamedPoint> points_from(const Json& json) {
  std::vector<NamedPoint> points;
  for (const auto& [name, position] : json.items()) points.push_back({name, point_from(position)});
  return points;
}

PointQuantity point_quantity_from(const Json& json) { return {json.at(0), json.at(1)}; }

SeaRelations relations_from(const Json& json) {
  SeaRelations relations;
  for (const Json& pair : json.at("cross_spectra"))
    relations.pairs.push_back({point_quantity_from(pair.at(0)), point_quantity_from(pair.at(1))});
  for (const Json& own : json.at("combinations")) {
    Combination combination{
        own.at("name"),
        own.at("kind") == "sum" ? Combination::Kind::kSum : Combination::Kind::kVonMises,
        {}};
    for (const Json& term : own.at("terms"))
      combination.terms.push_back({point_quantity_from(term.at("of")), term.at("factor")});
    relations.combinations.push_back(std::move(combination));
  }
  return relations;
}

void read_output(const Json& output, Case& data) {
  data.points = points_from(output.at("points"));
  data.wave_points = points_from(output.at("wave_points"));
  for (const auto& [name, line] : output.at("lines").items())
    data.lines.push_back(
        {name, point_from(line.at("from")), point_from(line.at("to")), line.at("count")});
  data.quantities.clear();
  for (const Json& name : output.at("quantities")) {
    const auto quantity = response::quantity_from_name(name.get<std::string>());
    FLOE_VALIDATE_AS(StoreError, quantity, "unknown quantity " << name);
    data.quantities.push_back(*quantity);
  }
  data.relations = relations_from(output.at("relations"));
  data.node_spectra = output.at("node_spectra");
  for (const Json& field : output.at("fields"))
    data.fields.push_back({field.at("omega"), field.at("heading_deg")});
}

Case read_case_json(const Json& options) {
  Case data;
  data.title = options.at("title");
  const Json &water = options.at("water"), &plate = options.at("plate");
  data.water = {.depth = water.at("depth").is_string() ? std::numeric_limits<double>::infinity()
                                                       : water.at("depth").get<double>(),
                .density = water.at("density"),
                .gravity = water.at("gravity")};
  data.plate = {.thickness = plate.at("thickness"),
                .youngs_modulus = plate.at("youngs_modulus"),
                .poisson_ratio = plate.at("poisson_ratio"),
                .density = plate.at("density"),
                .shear_correction = plate.at("shear_correction"),
                .loss_factor = plate.at("loss_factor")};
  for (const Json& region : plate.value("region", Json::array())) {
    PlateRegion read{region.at("name"), data.plate};
    read.properties.thickness = region.at("thickness");
    read.properties.youngs_modulus = region.at("youngs_modulus");
    read.properties.poisson_ratio = region.at("poisson_ratio");
    read.properties.density = region.at("density");
    data.regions.push_back(std::move(read));
  }
  if (plate.contains("mesh")) data.plate_mesh.push_back(mesh_source_from(plate.at("mesh")));
  data.mesh = mesh_source_from(options.at("mesh"));
  data.mode_count = options.at("modes").at("count");
  data.omega = options.at("waves").at("omega").get<std::vector<double>>();
  data.heading_deg = options.at("waves").at("heading_deg").get<std::vector<double>>();
  for (const SolverMethod method :
       {SolverMethod::kDense, SolverMethod::kLattice, SolverMethod::kPfft, SolverMethod::kFmm})
    if (options.at("solver").at("method") == method_name(method)) data.method = method;
  for (const SolverRoute route : {SolverRoute::kModal, SolverRoute::kDirect})
    if (options.at("solver").at("route") == route_name(route)) data.route = route;
  data.tolerance = options.at("solver").at("tolerance");
  const Json& grid = options.at("sea_grid");
  data.sea_grid.tolerance = grid.at("tolerance");
  if (grid.contains("from")) data.sea_grid.from = grid.at("from").get<double>();
  if (grid.contains("to")) data.sea_grid.to = grid.at("to").get<double>();
  data.allow_coarse = options.at("allow_coarse");
  read_output(options.at("output"), data);
  return data;
}

}  // namespace

Json case_json(const Case& data) {
  const auto& p = data.plate;
  Json plate = {{"thickness", p.thickness},
                {"youngs_modulus", p.youngs_modulus},
                {"poisson_ratio", p.poisson_ratio},
                {"density", p.density},
                {"shear_correction", p.shear_correction},
                {"loss_factor", p.loss_factor}};
  if (data.structure) {
    for (const auto& [key, path] : data.structure->files) plate["structure"][key] = path.string();
    plate["structure"]["hash"] = data.structure->hash;
  }
  for (const PlateRegion& region : data.regions)
    plate["region"].push_back({{"name", region.name},
                               {"thickness", region.properties.thickness},
                               {"youngs_modulus", region.properties.youngs_modulus},
                               {"poisson_ratio", region.properties.poisson_ratio},
                               {"density", region.properties.density}});
  if (!data.plate_mesh.empty()) plate["mesh"] = json_of(data.plate_mesh.front());
  const Json depth = std::isinf(data.water.depth) ? Json("inf") : Json(data.water.depth);
  return {{"title", data.title},
          {"water",
           {{"depth", depth}, {"density", data.water.density}, {"gravity", data.water.gravity}}},
          {"plate", plate},
          {"mesh", json_of(data.mesh)},
          {"modes", {{"count", data.mode_count}}},
          {"waves", {{"omega", data.omega}, {"heading_deg", data.heading_deg}}},
          {"solver",
           {{"method", method_name(data.method)},
            {"route", route_name(data.route)},
            {"tolerance", data.tolerance}}},
          {"sea_grid", sea_grid_json(data)},
          {"sea", seas_json(data)},
          {"output", output_json(data)},
          {"allow_coarse", data.allow_coarse}};
}

Case case_from_json(const Json& options) {
  try {
    return read_case_json(options);
  } catch (const Json::exception& error) {
    throw StoreError(std::string("the stored case is not complete: ") + error.what());
  }
}

}  // namespace floe::io
