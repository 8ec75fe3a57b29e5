#include "io/case_json.hpp"
#include "io/manifest.hpp"
#include "io/record_names.hpp"
#include "io/regular_file.hpp"
#include "io/result_records.hpp"

#include <floe/io/stored_run.hpp>
#include <floe/numeric/error.hpp>
#include <floe/unsolved_frequency.hpp>

#include <limits>

namespace floe::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kLargestAccount = std::uintmax_t{256} << 20;

Json read_json(const std::filesystem::path& path) {
  try {
    return Json::parse(read_regular_file(path, kLargestAccount));
  } catch (const Json::exception&) {
    throw StoreError(path.string() + " is no account of floe (give the directory of a run)");
  } catch (const InputError&) {
    throw StoreError("no result of floe in " + path.parent_path().string() + ": " +
                     path.filename().string() +
                     " cannot be read (give the directory of a finished run)");
  }
}

SelfCheck check_from(const Json& json) {
  const Json& value = json.at("value");
  SelfCheck check{
      .name = json.at("name"),
      .value = value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>(),
      .limit = json.at("limit"),
      .omega = json.at("omega"),
      .meaning = json.at("meaning")};
  for (const CheckStatus status : {CheckStatus::kGood, CheckStatus::kAttention, CheckStatus::kBad})
    if (json.at("status") == status_name(status)) check.status = status;
  return check;
}

}  // namespace

StoredRun::StoredRun(std::filesystem::path directory) : directory_(std::move(directory)) {
  const bool lost = std::filesystem::exists(record(kManifest)) &&
                    !std::filesystem::exists(directory_ / "run.json");
  const Json account = lost ? Json::object() : read_json(directory_ / "run.json");
  const Json manifest = read_manifest(directory_, kAdviceToRead);
  manifest_ = manifest.dump();
  if (!lost) account_ = account.dump();
  data_ = case_from_json(manifest.at("options"));
  try {
    text_ = manifest.at("case_text");
    data_.plan_memory = manifest.value("plan_memory", 0.0);
    if (manifest.contains("shard"))
      data_.shard = {manifest.at("shard").at("index"), manifest.at("shard").at("count")};
    status_ = lost ? "not known" : account.at("status").get<std::string>();
    warnings_ = account.value("warnings", std::vector<std::string>());
    for (const Json& stage : account.value("stages", Json::array()))
      stages_.push_back({stage.at("stage"), stage.at("seconds"), stage.at("peak_memory")});
    seconds_before_ = account.value("seconds_before", 0.0);
    for (const Json& check : account.value("checks", Json::array()))
      checks_.push_back(check_from(check));
    for (const Json& sea : manifest.at("options").at("sea")) {
      sea_names_.push_back(sea.at("name"));
      sea_descriptions_.push_back(sea.at("description"));
    }
  } catch (const Json::exception& error) {
    throw StoreError("the account of " + directory_.string() + " is not complete: " + error.what());
  }
}

int StoredRun::threads() const {
  const Json account = account_.empty() ? Json::object() : Json::parse(account_);
  return account.contains("plan") ? account.at("plan").value("threads", 1) : 1;
}

bool StoredRun::wants_seas() const {
  const bool range = data_.sea_grid.from && data_.sea_grid.to;
  return data_.shard.holds_seas() && (range || !sea_names_.empty());
}

Estimate StoredRun::plan() const {
  Case data = data_;
  data.seas.resize(sea_names_.size());  // only how many there are matters
  const std::optional<mesh::Q8Mesh> own =
      data.plate_mesh.empty() ? std::nullopt : std::optional(mode_mesh());
  return estimate(data, fluid_mesh(), own ? &*own : nullptr, threads());
}

std::filesystem::path StoredRun::record(const std::string& name) const { return directory_ / name; }

mesh::Q8Mesh StoredRun::fluid_mesh() const { return mesh_from(Record::read(record(kFluidMesh))); }

mesh::Q8Mesh StoredRun::mode_mesh() const {
  const bool own = std::filesystem::exists(record(kModeMesh));
  return mesh_from(Record::read(record(own ? kModeMesh : kFluidMesh)));
}

plate::DryModes StoredRun::modes() const {
  FLOE_VALIDATE_AS(StoreError, data_.route == SolverRoute::kModal,
                   directory_.string() << " was solved by the direct route, which knows no modes "
                                          "(must be solved with solver.route = \"modal\")");
  return modes_from(Record::read(record(kModes)));
}

bool StoredRun::has_frequency(std::size_t place) const {
  return std::filesystem::exists(record(numbered_record("frequency", place)));
}

FrequencyResult StoredRun::frequency(std::size_t place) const {
  return frequency_from(Record::read(record(numbered_record("frequency", place))));
}

std::string StoredRun::failure(std::size_t place) const {
  const std::filesystem::path path = record(numbered_record("failure", place));
  if (has_frequency(place) || !std::filesystem::exists(path)) return "";
  return failure_from(Record::read(path));
}

std::optional<FrequencyResult> StoredRun::tried_frequency(std::size_t place,
                                                          Index mode_count) const {
  if (has_frequency(place)) return frequency(place);
  std::string why = failure(place);
  if (why.empty()) return std::nullopt;
  return unsolved_frequency(data_, mode_count, data_.omega[place], std::move(why));
}

std::vector<FrequencyResult> StoredRun::frequencies() const {
  std::vector<FrequencyResult> results;
  for (std::size_t i = 0; i < data_.omega.size(); ++i)
    if (has_frequency(i)) results.push_back(frequency(i));
  return results;
}

std::optional<SeaGridReport> StoredRun::finished_seas() const {
  if (!std::filesystem::exists(record(kSeaGrid))) return std::nullopt;
  return finished_grid_from(Record::read(record(kSeaGrid)));
}

std::vector<SeaResult> StoredRun::seas() const {
  std::vector<SeaResult> results;
  for (std::size_t i = 0;; ++i) {
    const std::filesystem::path path = record(numbered_record("sea", i));
    if (!std::filesystem::exists(path)) return results;
    results.push_back(sea_from(Record::read(path)));
  }
}

RunResults StoredRun::results() const {
  RunResults results;
  results.data = data_;
  results.data.text = text_;
  results.fluid_mesh = fluid_mesh();
  results.mode_mesh = mode_mesh();
  if (data_.route == SolverRoute::kModal) results.modes = modes();
  const Index count = data_.route == SolverRoute::kModal ? results.modes.count() : 0;
  for (std::size_t i = 0; i < data_.omega.size(); ++i)
    if (std::optional<FrequencyResult> tried = tried_frequency(i, count))
      results.frequencies.push_back(std::move(*tried));
  results.seas = seas();
  if (const std::optional<SeaGridReport> grid = finished_seas()) results.sea_grid = *grid;
  results.stages = stages_;
  results.warnings = warnings_;
  return results;
}

bool StoredRun::has_transfers() const { return std::filesystem::exists(record(kObservation)); }

SeaObservation StoredRun::observation() const {
  return observation_from(Record::read(record(kObservation)));
}

SeaGridReport StoredRun::sea_grid() const {
  return sea_grid_from(Record::read(record(kObservation)));
}

SeaTransfer StoredRun::transfer(std::size_t place) const {
  return transfer_from(Record::read(record(numbered_record("transfer", place))));
}

}  // namespace floe::io
