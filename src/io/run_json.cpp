#include "io/run_json.hpp"

#include "io/regular_file.hpp"

#include <floe/numeric/error.hpp>
#include <floe/numeric/memory.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kLargestAccount = std::uintmax_t{256} << 20;

// How fine the mesh is for the waves of one frequency
void add_resolution(const std::vector<Resolution>& all, double omega, Json& frequency) {
  for (const Resolution& r : all) {
    if (r.omega != omega) continue;
    frequency["nodes_per_wavelength"] = r.nodes_per_wavelength;
    frequency["flexural_wavelength"] = r.flexural_wavelength;
    frequency["nodes_per_flexural_wavelength"] = r.nodes_per_flexural_wavelength;
  }
}

void add_worth(const FrequencyReport& report, Json& frequency) {
  frequency["method"] = report.method;
  frequency["iterations"] = report.iterations;
  frequency["applications"] = report.applications;
  frequency["true_residual"] = report.true_residual;
  frequency["kernel_error"] = report.kernel_error;
  frequency["reciprocity_error"] = report.reciprocity_error;
  frequency["energy_error"] = report.energy_error;
  frequency["exact_residual"] = report.exact_residual;
  frequency["residual_between_nodes"] = report.residual_between_nodes;
  frequency["mode_change"] = report.mode_change;
  frequency["passivity_error"] = report.passivity_error;
}

// The frequencies that were solved for the seas, by rising ω
Json solved_json(const RunAccount& account) {
  std::vector<SolvedSeaFrequency> all = account.sea_grid.solved;
  std::sort(all.begin(), all.end(), [](const SolvedSeaFrequency& a, const SolvedSeaFrequency& b) {
    return a.report.omega < b.report.omega;
  });
  double largest = 0.0;
  for (const SolvedSeaFrequency& one : all) largest = std::max(largest, one.response);
  Json solved = Json::array();
  for (const SolvedSeaFrequency& one : all) {
    Json entry = {{"omega", one.report.omega},
                  {"share_of_response", largest > 0.0 ? one.response / largest : 0.0}};
    add_worth(one.report, entry);
    if (one.pressure_error > 0.0) entry["pressure_error"] = one.pressure_error;
    add_resolution(account.sea_resolution, one.report.omega, entry);
    solved.push_back(entry);
  }
  return solved;
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
                    {"band_height", sea.band_height},
                    {"spreading_sum", sea.spreading_sum},
                    {"share_outside", sea.share_outside},
                    {"grid_error", sea.grid_error}});
  Json climates = Json::array();
  for (const RunAccount::Climate& climate : account.climates)
    climates.push_back({{"scatter", climate.name},
                        {"description", climate.description},
                        {"share_outside", climate.share_outside},
                        {"grid_error", climate.grid_error}});
  return {{"from", grid.omega.front()},
          {"to", grid.omega.back()},
          {"frequencies", grid.omega.size()},
          {"solved_frequencies", grid.solved_frequencies},
          {"interpolation_error", grid.interpolation_error},
          {"pressure_error", grid.pressure_error},
          {"headings", grid.headings},
          {"solved", solved_json(account)},
          {"results", seas},
          {"scatter", climates}};
}

Json plan_json(const RunAccount& account) {
  return {{"method", account.plan.method},
          {"threads", account.threads},
          {"processors", processors_of(account)},
          {"estimated_memory", account.plan.memory},
          {"estimated_seconds", account.plan.seconds}};
}

Json checks_json(const std::vector<SelfCheck>& all) {
  Json checks = Json::array();
  for (const SelfCheck& check : all)
    checks.push_back({{"name", check.name},
                      {"value", check.value},
                      {"limit", check.limit},
                      {"omega", check.omega},
                      {"status", status_name(check.status)},
                      {"meaning", check.meaning}});
  return checks;
}

Json frequency_json(const FrequencyReport& report, double wavenumber) {
  const double wavelength = 2.0 * std::numbers::pi / wavenumber;
  if (!report.failure.empty())
    return {{"omega", report.omega},
            {"wavelength", wavelength},
            {"status", "failed"},
            {"failure", report.failure}};
  Json frequency = {{"omega", report.omega}, {"wavelength", wavelength}, {"status", "solved"}};
  add_worth(report, frequency);
  frequency["seconds"] = report.seconds;
  return frequency;
}

}  // namespace

std::set<std::string> processors_of(const RunAccount& account) {
  std::set<std::string> kinds;
  for (const FrequencyReport& report : account.frequencies)
    if (!report.processor.empty()) kinds.insert(report.processor);
  return kinds;
}

RunAccount::Sea summary_of(const SeaResult& result) {
  return {result.sea,         result.mean_heading_deg, result.significant_height,
          result.band_height, result.spreading_sum,    result.share_outside,
          result.grid_error};
}

RunAccount::Climate summary_of(const LongTermResult& result) {
  return {result.climate.name, result.climate.description, result.energy_outside(),
          result.grid_error};
}

std::string run_json(const Json& options, const RunAccount& account) {
  Json frequencies = Json::array(), stages = Json::array();
  for (std::size_t i = 0; i < account.frequencies.size(); ++i) {
    frequencies.push_back(frequency_json(account.frequencies[i], account.wavenumber[i]));
    add_resolution(account.resolution, account.frequencies[i].omega, frequencies.back());
  }
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
      {"options", options},
      {"plan", plan_json(account)},
      {"mesh",
       {{"nodes", account.nodes},
        {"elements", account.elements},
        {"pieces", account.pieces},
        {"area", account.area},
        {"hash", account.mesh_hash}}},
      {"method", account.plan.method},
      {"route", options.at("solver").at("route")},
      {"left_out", account.left_out},
      {"nodes", account.nodes},
      {"modes",
       {{"count", account.dry_omega.size()},
        {"omega", account.dry_omega},
        {"estimated_frequency_error", account.dry_omega_error}}},
      {"frequencies", frequencies},
      {"seas", sea_results_json(account)},
      {"checks", checks_json(account.checks)},
      {"warnings", account.warnings},
      {"stages", stages},
      {"seconds_before", account.seconds_before},
      {"peak_memory", account.peak_memory > 0.0 ? account.peak_memory : numeric::peak_memory()},
      {"files", account.files}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string status_of_run(const std::filesystem::path& account) {
  try {
    return Json::parse(read_regular_file(account, kLargestAccount)).at("status");
  } catch (const Json::exception&) {
  } catch (const InputError&) {
  }
  return "";
}

double seconds_of_run(const std::filesystem::path& account) {
  try {
    const Json document = Json::parse(read_regular_file(account, kLargestAccount));
    double sum = document.value("seconds_before", 0.0);
    for (const Json& stage : document.at("stages")) sum += stage.at("seconds").get<double>();
    return sum;
  } catch (const Json::exception&) {
  } catch (const InputError&) {
  }
  return 0.0;
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
