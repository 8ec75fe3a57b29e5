#include "io/case_json.hpp"
#include "io/output_directory.hpp"
#include "io/record_names.hpp"
#include "io/result_records.hpp"
#include "io/result_tables.hpp"
#include "io/run_json.hpp"
#include "io/sea_tables.hpp"
#include "io/vtu.hpp"

#include <floe/io/directory_store.hpp>
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

namespace floe::io {

namespace {

void make_folder(const std::filesystem::path& folder) {
  if (::mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST)
    throw FileError("cannot write to " + folder.string() + ": " + std::strerror(errno));
}

}  // namespace

class DirectoryStore::Impl {
 public:
  Impl(const std::filesystem::path& path, Existing existing) : directory(path, existing) {}

  void begin(const Case& given, const mesh::Q8Mesh& given_mesh);
  void modes(const plate::DryModes& dry, const mesh::Q8Mesh& mesh);
  void frequency(const FrequencyResult& result);
  void begin_seas(const SeaObservation& observation, const SeaGridReport& planned);
  void sea_transfer(const SeaTransfer& transfer);
  void sea(const SeaResult& result) { seas_.push_back(result); }
  void end_seas(const SeaGridReport& grid);
  void end(const std::string& status);

  OutputDirectory directory;
  RunAccount account;

 private:
  std::filesystem::path file(const std::string& name) const { return directory.path() / name; }
  void write_account() { write_file(file("run.json"), run_json(data_, account)); }
  void write_fields(const FrequencyResult& result);
  void write_manifest() const;
  void plan_records();
  void warn_of_truncation(const SeaResult& sea);
  PvdEntry entry_of(const NodeField& field) const;

  Case data_;
  const mesh::Q8Mesh* mesh_ = nullptr;  // view, until the end
  std::vector<std::string> remarks_;
  std::optional<ResultTables> tables_;
  std::vector<PvdEntry> fields_;
  std::vector<SeaResult> seas_;
  std::size_t transfers_ = 0;  // stored so far
};

void DirectoryStore::Impl::begin(const Case& given, const mesh::Q8Mesh& given_mesh) {
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
  account.plan = estimate(given, given_mesh, account.threads);
  account.warnings = preflight(given, given_mesh).warnings;
  account.files = product_names();
  if (!data_.title.empty()) remarks_.push_back(data_.title);
  for (const std::string& warning : account.warnings) remarks_.push_back("warning: " + warning);

  // Claim the directory: the account first, so that every file of the run is listed
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

void DirectoryStore::Impl::write_manifest() const {
  const nlohmann::ordered_json manifest = {{"program", "floe"},
                                           {"version", FLOE_VERSION},
                                           {"mesh_hash", account.mesh_hash},
                                           {"options", case_json(data_)},
                                           {"case_text", data_.text}};
  write_file(file(kManifest),
             manifest.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void DirectoryStore::Impl::modes(const plate::DryModes& dry, const mesh::Q8Mesh& mode_mesh) {
  record_of(dry).write(file(kModes));
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
  record_of(result).write(file(numbered_record("frequency", account.frequencies.size())));
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
  account.files.push_back(kObservation);
  for (std::size_t i = 0; i < planned.omega.size(); ++i)
    account.files.push_back(numbered_record("transfer", i));
  for (std::size_t s = 0, i = 0; s < data_.seas.size(); ++s)
    for (std::size_t m = 0; m < data_.seas[s].mean_heading_deg.size(); ++m, ++i)
      account.files.push_back(numbered_record("sea", i));
  write_account();
  record_of(observation, planned).write(file(kObservation));
}

void DirectoryStore::Impl::sea_transfer(const SeaTransfer& transfer) {
  record_of(transfer).write(file(numbered_record("transfer", transfers_++)));
}

void DirectoryStore::Impl::end_seas(const SeaGridReport& grid) {
  account.sea_grid = grid;
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
    directory.remove(account.files);
    return;
  }
  tables_->rollback();
  tables_->commit();
  tables_.reset();
  write_pvd(file("fields.pvd"), fields_);
  account.status = status;
  write_account();
}

DirectoryStore::DirectoryStore(const std::filesystem::path& directory, Existing existing)
    : impl_(std::make_unique<Impl>(directory, existing)) {}

DirectoryStore::~DirectoryStore() = default;

void DirectoryStore::begin(const Case& data, const mesh::Q8Mesh& mesh) { impl_->begin(data, mesh); }

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
