#include "io/case_json.hpp"
#include "io/output_directory.hpp"
#include "io/record_names.hpp"
#include "io/result_records.hpp"
#include "io/result_tables.hpp"
#include "io/run_json.hpp"
#include "io/sea_tables.hpp"
#include "io/vtu.hpp"

#include <floe/io/directory_store.hpp>
#include <floe/io/interchange.hpp>
#include <floe/io/stored_run.hpp>
#include <floe/mesh/mesh_hash.hpp>
#include <floe/numeric/error.hpp>
#include <floe/preflight.hpp>

#include <fmt/format.h>
#include <omp.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <set>

namespace floe::io {

namespace {

nlohmann::ordered_json manifest_json(const Case& data, const std::string& mesh_hash) {
  return {{"program", "floe"},
          {"version", FLOE_VERSION},
          {"mesh_hash", mesh_hash},
          {"options", case_json(data)},
          {"case_text", data.text}};
}

void make_folder(const std::filesystem::path& folder) {
  if (::mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST)
    throw FileError("cannot write to " + folder.string() + ": " + std::strerror(errno));
}

}  // namespace

class DirectoryStore::Impl {
 public:
  Impl(const std::filesystem::path& path, Existing existing)
      : directory(path, existing), resume_(existing == Existing::kResume) {}

  // A record of the earlier run, decoded; nothing where it is missing or damaged
  template <typename Decode>
  auto known(const std::string& name, Decode decode) -> std::optional<decltype(decode(Record()))>;
  bool knows_all_transfers(const SeaGridReport& grid);

  void begin(const Case& given, const mesh::Q8Mesh& given_mesh, const Estimate& plan);
  void modes(const plate::DryModes& dry, const mesh::Q8Mesh& mesh);
  void frequency(const FrequencyResult& result);
  void begin_seas(const SeaObservation& observation, const SeaGridReport& planned);
  void sea_transfer(const SeaTransfer& transfer);
  void sea(const SeaResult& result) { seas_.push_back(result); }
  void end_seas(const SeaGridReport& grid);
  void end(const std::string& status);

  OutputDirectory directory;
  RunAccount account;
  std::vector<std::string> damaged;

 private:
  std::filesystem::path file(const std::string& name) const { return directory.path() / name; }
  void write_account() { write_file(file("run.json"), run_json(data_, account)); }
  void write_fields(const FrequencyResult& result);
  void write_manifest() const;
  void plan_records();
  void warn_of_truncation(const SeaResult& sea);
  PvdEntry entry_of(const NodeField& field) const;

  void require_same_case() const;
  void store_record(const std::string& name, const Record& record);

  bool resume_;
  std::set<std::string> good_;  // records of the earlier run that were read
  Case data_;
  const mesh::Q8Mesh* mesh_ = nullptr;  // view, until the end
  std::vector<std::string> remarks_;
  std::optional<ResultTables> tables_;
  std::vector<PvdEntry> fields_;
  std::vector<SeaResult> seas_;
  std::size_t transfers_ = 0;  // stored so far
};

void DirectoryStore::Impl::begin(const Case& given, const mesh::Q8Mesh& given_mesh,
                                 const Estimate& plan) {
  data_ = given;
  mesh_ = &given_mesh;

  // Describe the run
  account.status = "running";
  account.mesh_hash = mesh::mesh_hash(given_mesh);
  account.nodes = given_mesh.node_count();
  account.elements = given_mesh.element_count();
  account.pieces = given_mesh.piece_count();
  account.area = given_mesh.area();
  account.threads = omp_get_max_threads();
  account.plan = plan;
  account.warnings = preflight(given, given_mesh).warnings;
  account.files = product_names();
  if (!data_.title.empty()) remarks_.push_back(data_.title);
  for (const std::string& warning : account.warnings) remarks_.push_back("warning: " + warning);

  // Claim the directory: the account first, so that every file of the run is listed
  resume_ = resume_ && std::filesystem::exists(file(kManifest));
  if (resume_) require_same_case();
  if (resume_)
    directory.clear_leftovers();
  else
    directory.clear_earlier_run();
  plan_records();
  write_account();
  make_folder(file("records"));
  write_manifest();
  record_of(given_mesh).write(file(kFluidMesh));
  tables_.emplace(directory.path(), remarks_);
}

// The records that are written whatever comes
void DirectoryStore::Impl::plan_records() {
  account.files.insert(account.files.end(), {kManifest, kFluidMesh, kModeMesh, kModes});
  for (std::size_t i = 0; i < data_.omega.size(); ++i)
    account.files.push_back(numbered_record("frequency", i));
}

// Names what differs between the earlier run's case and this one
void DirectoryStore::Impl::require_same_case() const {
  const StoredRun earlier(directory.path());
  // NOTE: through text, as the other was
  nlohmann::ordered_json mine =
      nlohmann::ordered_json::parse(manifest_json(data_, account.mesh_hash).dump());
  nlohmann::ordered_json theirs = nlohmann::ordered_json::parse(earlier.manifest_text());
  for (nlohmann::ordered_json* manifest : {&mine, &theirs}) {
    manifest->erase("case_text");
    if (manifest->contains("options")) (*manifest)["options"].erase("title");
  }
  std::string differing;
  for (const auto& change : nlohmann::ordered_json::diff(theirs, mine))
    differing += (differing.empty() ? "" : ", ") + change.at("path").get<std::string>();
  FLOE_VALIDATE_AS(StoreError, differing.empty(),
                   directory.path().string()
                       << " holds results of another case: " << differing
                       << " differ (give --fresh to replace them, or another directory with -o)");
}

// What the earlier run stored well stays
void DirectoryStore::Impl::store_record(const std::string& name, const Record& record) {
  if (!good_.contains(name)) record.write(file(name));
}

template <typename Decode>
auto DirectoryStore::Impl::known(const std::string& name, Decode decode)
    -> std::optional<decltype(decode(Record()))> {
  if (!resume_ || !std::filesystem::exists(file(name))) return std::nullopt;
  try {
    auto value = decode(Record::read(file(name)));
    good_.insert(name);
    return value;
  } catch (const StoreError&) {
    damaged.push_back("record " + file(name).string() + " is damaged");
    return std::nullopt;
  }
}

bool DirectoryStore::Impl::knows_all_transfers(const SeaGridReport& grid) {
  bool all = known(kObservation, observation_from).has_value();
  for (std::size_t i = 0; all && i < grid.omega.size(); ++i)
    all = known(numbered_record("transfer", i), transfer_from).has_value();
  return all;
}

void DirectoryStore::Impl::write_manifest() const {
  const nlohmann::ordered_json manifest = manifest_json(data_, account.mesh_hash);
  write_file(file(kManifest),
             manifest.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void DirectoryStore::Impl::modes(const plate::DryModes& dry, const mesh::Q8Mesh& mode_mesh) {
  store_record(kModes, record_of(dry));
  if (&mode_mesh != mesh_) record_of(mode_mesh).write(file(kModeMesh));
  account.dry_omega.assign(dry.omega.data(), dry.omega.data() + dry.omega.size());
  account.dry_omega_error = dry.estimated_frequency_error;
  write_dry_modes(directory.path(), remarks_, dry);
}

void DirectoryStore::Impl::frequency(const FrequencyResult& result) {
  tables_->add(data_, result);
  if (!result.fields.empty()) {
    for (const NodeField& field : result.fields) account.files.push_back(entry_of(field).file);
    write_account();
    write_fields(result);
  }
  tables_->mark();
  store_record(numbered_record("frequency", account.frequencies.size()), record_of(result));
  account.frequencies.push_back(result.report);
  account.wavenumber.push_back(result.wavenumber);
}

PvdEntry DirectoryStore::Impl::entry_of(const NodeField& field) const {
  const auto heading =
      std::find(data_.heading_deg.begin(), data_.heading_deg.end(), field.heading_deg);
  return {.omega = field.omega,
          .heading = static_cast<int>(heading - data_.heading_deg.begin()),
          .file = "fields/omega_" + shortest(field.omega) + "_heading_" +
                  shortest(field.heading_deg) + ".vtu"};
}

void DirectoryStore::Impl::write_fields(const FrequencyResult& result) {
  make_folder(file("fields"));
  for (const NodeField& field : result.fields) {
    const PvdEntry entry = entry_of(field);
    write_vtu(file(entry.file), *mesh_, field);
    fields_.push_back(entry);
  }
}

// As the run itself warned; once a sea
void DirectoryStore::Impl::warn_of_truncation(const SeaResult& sea) {
  constexpr double kShareTold = 0.02;
  if (sea.share_outside <= kShareTold) return;
  const std::string warning =
      fmt::format("sea {}: {:.2g} % of its m0 lie outside the frequencies that were computed",
                  sea.sea, 100.0 * sea.share_outside);
  if (std::find(account.warnings.begin(), account.warnings.end(), warning) !=
      account.warnings.end())
    return;
  account.warnings.push_back(warning);
  remarks_.push_back("warning: " + warning);
}

void DirectoryStore::Impl::begin_seas(const SeaObservation& observation,
                                      const SeaGridReport& planned) {
  account.files.insert(account.files.end(), {kObservation, kSeaGrid});
  for (std::size_t i = 0; i < planned.omega.size(); ++i)
    account.files.push_back(numbered_record("transfer", i));
  for (std::size_t s = 0, i = 0; s < data_.seas.size(); ++s)
    for (std::size_t m = 0; m < data_.seas[s].mean_heading_deg.size(); ++m, ++i)
      account.files.push_back(numbered_record("sea", i));
  write_account();
  store_record(kObservation, record_of(observation, planned));
}

void DirectoryStore::Impl::sea_transfer(const SeaTransfer& transfer) {
  store_record(numbered_record("transfer", transfers_++), record_of(transfer));
}

void DirectoryStore::Impl::end_seas(const SeaGridReport& grid) {
  account.sea_grid = grid;
  store_record(kSeaGrid, record_of(grid));
  if (seas_.empty()) return;
  for (const SeaResult& sea : seas_) {
    account.seas.push_back(summary_of(sea));
    warn_of_truncation(sea);
  }
  account.files.insert(account.files.end(), sea_table_names().begin(), sea_table_names().end());
  account.files.emplace_back("statistics.vtu");
  write_account();
  for (std::size_t i = 0; i < seas_.size(); ++i)
    record_of(seas_[i]).write(file(numbered_record("sea", i)));
  write_sea_tables(directory.path(), remarks_, data_, seas_);
  write_statistics_vtu(file("statistics.vtu"), *mesh_, seas_);
}

void DirectoryStore::Impl::end(const std::string& status) {
  mesh_ = nullptr;
  if (!tables_) return;
  if (account.frequencies.empty()) {
    tables_.reset();
    if (!resume_) directory.remove(account.files);
    return;
  }
  tables_->rollback();
  tables_->commit();
  tables_.reset();
  write_pvd(file("fields.pvd"), fields_);
  write_netcdf(StoredRun(directory.path()), file("result.nc"), plate::DofSet::kPlate);
  account.status = status;
  write_account();
}

DirectoryStore::DirectoryStore(const std::filesystem::path& directory, Existing existing)
    : impl_(std::make_unique<Impl>(directory, existing)) {}

DirectoryStore::~DirectoryStore() = default;

std::optional<plate::DryModes> DirectoryStore::known_modes() {
  return impl_->known(kModes, modes_from);
}

std::optional<FrequencyResult> DirectoryStore::known_frequency(std::size_t place) {
  return impl_->known(numbered_record("frequency", place), frequency_from);
}

std::optional<SeaGridReport> DirectoryStore::known_sea_grid() {
  std::optional<SeaGridReport> grid = impl_->known(kSeaGrid, finished_grid_from);
  if (grid && !impl_->knows_all_transfers(*grid)) return std::nullopt;
  return grid;
}

SeaTransfer DirectoryStore::known_transfer(std::size_t place) {
  return transfer_from(Record::read(directory() / numbered_record("transfer", place)));
}

SeaObservation DirectoryStore::known_observation() {
  return observation_from(Record::read(directory() / kObservation));
}

const std::vector<std::string>& DirectoryStore::damaged_records() const { return impl_->damaged; }

void DirectoryStore::begin(const Case& data, const mesh::Q8Mesh& mesh, const Estimate& plan) {
  impl_->begin(data, mesh, plan);
}

void DirectoryStore::modes(const plate::DryModes& modes, const mesh::Q8Mesh& mesh) {
  impl_->modes(modes, mesh);
}

void DirectoryStore::frequency(const FrequencyResult& result) { impl_->frequency(result); }

void DirectoryStore::begin_seas(const SeaObservation& observation, const SeaGridReport& planned) {
  impl_->begin_seas(observation, planned);
}

void DirectoryStore::sea_transfer(const SeaTransfer& transfer) { impl_->sea_transfer(transfer); }

void DirectoryStore::sea(const SeaResult& result) { impl_->sea(result); }

void DirectoryStore::end_seas(const SeaGridReport& grid) { impl_->end_seas(grid); }

void DirectoryStore::finish(const std::vector<StageTime>& times) {
  impl_->account.stages = times;
  impl_->end("complete");
}

void DirectoryStore::stop(const std::string& status) { impl_->end(status); }

const std::vector<std::string>& DirectoryStore::files() const { return impl_->account.files; }

const std::filesystem::path& DirectoryStore::directory() const { return impl_->directory.path(); }

}  // namespace floe::io
