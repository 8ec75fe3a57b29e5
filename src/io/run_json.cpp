#include "io/run_json.hpp"

#include "io/regular_file.hpp"

#include <floe/numeric/error.hpp>
#include <floe/numeric/memory.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace floe::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kLargestAccount = std::uintmax_t{256} << 20;

Json json_of(const Point2& point) { return Json::array({point.x(), point.y()}); }

Json json_of(const MeshSource& source) {
  if (const auto* file = std::get_if<std::filesystem::path>(&source))
    return {{"file", file->string()}};
  const auto& r = std::get<mesh::RectangleOptions>(source);
  return {{"rectangle",
           {{"length", r.length},
            {"width", r.width},
            {"nx", r.nx},
            {"ny", r.ny},
            {"grading", r.grading}}}};
}

Json json_of(const std::vector<NamedPoint>& points) {
  Json named = Json::object();
  for (const NamedPoint& point : points) named[point.name] = json_of(point.position);
  return named;
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

Json options_json(const Case& data) {
  const auto& p = data.plate;
  Json plate = {{"thickness", p.thickness},
                {"youngs_modulus", p.youngs_modulus},
                {"poisson_ratio", p.poisson_ratio},
                {"density", p.density},
                {"shear_correction", p.shear_correction},
                {"loss_factor", p.loss_factor}};
  if (!data.plate_mesh.empty()) plate["mesh"] = json_of(data.plate_mesh.front());
  const Json depth = std::isinf(data.water.depth) ? Json("inf") : Json(data.water.depth);
  return {
      {"title", data.title},
      {"water",
       {{"depth", depth}, {"density", data.water.density}, {"gravity", data.water.gravity}}},
      {"plate", plate},
      {"mesh", json_of(data.mesh)},
      {"modes", {{"count", data.mode_count}}},
      {"waves", {{"omega", data.omega}, {"heading_deg", data.heading_deg}}},
      {"solver",
       {{"method", method_name(data.method)}, {"route", "modal"}, {"tolerance", data.tolerance}}},
      {"sea_grid", sea_grid_json(data)},
      {"sea", seas_json(data)},
      {"output", output_json(data)},
      {"allow_coarse", data.allow_coarse}};
}

// What the seas' frequencies are worth, and what of each sea was left out
Json sea_results_json(const RunAccount& account) {
  const SeaGridReport& grid = account.sea_grid;
  if (grid.omega.empty()) return nullptr;
  Json seas = Json::array();
  for (const RunAccount::Sea& sea : account.seas)
    seas.push_back({{"sea", sea.name},
                    {"mean_heading_deg", sea.mean_heading_deg},
                    {"significant_height", sea.significant_height},
                    {"share_outside", sea.share_outside},
                    {"grid_error", sea.grid_error}});
  return {{"from", grid.omega.front()},
          {"to", grid.omega.back()},
          {"frequencies", grid.omega.size()},
          {"solved_frequencies", grid.solved_frequencies},
          {"interpolation_error", grid.interpolation_error},
          {"headings", grid.headings},
          {"results", seas}};
}

Json plan_json(const RunAccount& account) {
  return {{"method", account.plan.method},
          {"threads", account.threads},
          {"estimated_memory", account.plan.memory},
          {"estimated_seconds", account.plan.seconds}};
}

Json frequency_json(const FrequencyReport& report, double wavenumber) {
  return {{"omega", report.omega},
          {"wavelength", 2.0 * std::numbers::pi / wavenumber},
          {"method", report.method},
          {"iterations", report.iterations},
          {"applications", report.applications},
          {"true_residual", report.true_residual},
          {"kernel_error", report.kernel_error},
          {"reciprocity_error", report.reciprocity_error},
          {"energy_error", report.energy_error},
          {"seconds", report.seconds}};
}

}  // namespace

std::string run_json(const Case& data, const RunAccount& account) {
  Json frequencies = Json::array(), stages = Json::array();
  for (std::size_t i = 0; i < account.frequencies.size(); ++i)
    frequencies.push_back(frequency_json(account.frequencies[i], account.wavenumber[i]));
  for (const StageTime& stage : account.stages)
    stages.push_back(
        {{"stage", stage.stage}, {"seconds", stage.seconds}, {"peak_memory", stage.peak_memory}});
  const Json document = {
      {"program", "floe"},
      {"version", FLOE_VERSION},
      {"status", account.status},
      {"conventions",
       "SI units, e^{-iωt}, z up, per metre of wave amplitude, phases relative to "
       "the origin, heading: direction the waves travel to, from +x towards +y"},
      {"options", options_json(data)},
      {"plan", plan_json(account)},
      {"mesh",
       {{"nodes", account.nodes},
        {"elements", account.elements},
        {"pieces", account.pieces},
        {"area", account.area},
        {"hash", account.mesh_hash}}},
      {"method", account.plan.method},
      {"nodes", account.nodes},
      {"modes",
       {{"count", account.dry_omega.size()},
        {"omega", account.dry_omega},
        {"estimated_frequency_error", account.dry_omega_error}}},
      {"frequencies", frequencies},
      {"seas", sea_results_json(account)},
      {"warnings", account.warnings},
      {"stages", stages},
      {"peak_memory", numeric::peak_memory()},
      {"files", account.files}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::string> files_of_run(const std::filesystem::path& account) {
  try {
    const Json document = Json::parse(read_regular_file(account, kLargestAccount));
    if (document.at("program") == "floe")
      return document.at("files").get<std::vector<std::string>>();
  } catch (const Json::exception&) {
  } catch (const InputError&) {
  }
  throw StoreError(account.string() +
                   " does not tell which files floe made, so --fresh cannot replace them (remove "
                   "them, or give another directory with -o)");
}

}  // namespace floe::io
