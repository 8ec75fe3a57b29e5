#include "io/netcdf_parts.hpp"

#include <floe/io/interchange.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <ctime>

namespace floe::io {
namespace {

constexpr const char* kConventions =
    "SI units, radians; amplitudes of Re[X exp(-i omega t)] per metre of wave amplitude; phases "
    "relative to the wave at the origin, whose crest is there at t = 0; x and y in the calm "
    "surface, z up; wave_direction is the direction towards which waves travel, from +x towards "
    "+y; incident elevation exp(i k (x cos b + y sin b)); forces are those of the water on the "
    "plate. Complex variables have the dimension complex = re, im first. The equation of motion is "
    "(-omega^2 (inertia_matrix + added_mass) - i omega radiation_damping + hydrostatic_stiffness + "
    "structural_stiffness - i structural_damping) RAO = excitation_force.";

constexpr const char* kMotions =
    "Heave, Roll, Pitch: 1 m or 1 rad about rotation_center by the right hand about +x, +y, so "
    "positive pitch lowers the end at +x. The plate has no draft: Surge, Sway and Yaw, where they "
    "are, have inertia only. Elastic_n: dry mode n of dry_modes.csv, mass-normalised (its inertia "
    "is 1 kg m^2 per m^2 of amplitude squared, that is 1), largest deflection positive; amplitudes "
    "in kg^(1/2) m.";

std::string now() {
  // Builds and tests that want the same bytes each time say which time it is
  const char* const fixed = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t time = fixed ? std::strtoll(fixed, nullptr, 10) : std::time(nullptr);
  std::tm parts{};
  gmtime_r(&time, &parts);
  std::string text(32, '\0');
  text.resize(std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts));
  return text;
}

// Attributes may tell what differs between two equal runs; variables do not
void add_account(NetcdfFile& file, const StoredRun& run, const BodyResults& results) {
  const Case& data = run.data();
  const auto manifest = nlohmann::ordered_json::parse(run.manifest_text());
  file.add_attribute("", "title", data.title.empty() ? "floating plate in waves" : data.title);
  file.add_attribute("", "source", "floe " FLOE_VERSION);
  file.add_attribute("", "creation_of_dataset", now());
  file.add_attribute("", "conventions", kConventions);
  file.add_attribute("", "degrees_of_freedom", kMotions);
  const auto solved = std::find_if(results.frequencies.begin(), results.frequencies.end(),
                                   [](const BodyFrequency& f) { return f.report.failure.empty(); });
  if (solved != results.frequencies.end()) file.add_attribute("", "solver", solved->report.method);
  file.add_attribute("", "solver_tolerance", data.tolerance);
  file.add_attribute("", "frequencies_asked_for", static_cast<double>(data.omega.size()));
  file.add_attribute("", "mesh_hash", manifest.value("mesh_hash", ""));
  file.add_attribute("", "settings", manifest.value("options", nlohmann::ordered_json()).dump());
  std::string warnings;
  for (const std::string& warning : run.warnings()) warnings += warning + "\n";
  if (!warnings.empty()) file.add_attribute("", "warnings", warnings);
}

}  // namespace

void describe(NetcdfFile& file, const std::string& variable, const std::string& long_name,
              const std::string& units, const std::string& comment) {
  file.add_attribute(variable, "long_name", long_name);
  if (!units.empty()) file.add_attribute(variable, "units", units);
  if (!comment.empty()) file.add_attribute(variable, "comment", comment);
}

void add_axis(NetcdfFile& file, const std::string& name, const std::vector<std::string>& labels,
              const std::string& long_name) {
  if (labels.empty()) return;
  file.add_dimension(name, labels.size());
  file.add_texts(name, {name}, labels);
  describe(file, name, long_name);
}

std::vector<double> split_complex(const std::vector<MatXcd>& matrices) {
  std::vector<double> values;
  for (const bool imaginary : {false, true})
    for (const MatXcd& matrix : matrices)
      for (Index i = 0; i < matrix.size(); ++i)
        values.push_back(imaginary ? matrix(i).imag() : matrix(i).real());
  return values;
}

void write_netcdf(const StoredRun& run, const std::filesystem::path& path, plate::DofSet dofs) {
  const BodyResults results = body_results(run, dofs, Unsolved::kAsNan);
  NetcdfFile file = NetcdfFile::create(path);
  add_account(file, run, results);
  add_coordinates(file, run, results);
  add_hydrodynamics(file, results);
  add_solver(file, results);
  if (dofs != plate::DofSet::kSixRigid) {
    add_plate(file, run, results);
    add_places(file, run, results);
    add_seas(file, run);
  }
  file.close();
}

}  // namespace floe::io
