#include "io/output_directory.hpp"
#include "io/result_tables.hpp"
#include "io/run_json.hpp"
#include "io/sea_tables.hpp"
#include "io/vtu.hpp"

#include <floe/io/directory_store.hpp>
#include <floe/mesh/mesh_hash.hpp>
#include <floe/numeric/error.hpp>
#include <floe/preflight.hpp>

#include <omp.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>

namespace floe::io {

class DirectoryStore::Impl {
 public:
  Impl(const std::filesystem::path& path, Existing existing) : directory(path, existing) {}

  void begin(const Case& given, const mesh::Q8Mesh& given_mesh);
  void modes(const plate::DryModes& dry);
  void frequency(const FrequencyResult& result);
  void sea(const SeaResult& result) { seas_.push_back(result); }
  void end_seas(const SeaGridReport& grid);
  void end(const std::string& status);

  OutputDirectory directory;
  RunAccount account;

 private:
  std::filesystem::path file(const std::string& name) const { return directory.path() / name; }
  void write_account() { write_file(file("run.json"), run_json(data_, account)); }
  void write_fields(const FrequencyResult& result);
  PvdEntry entry_of(const NodeField& field) const;

  Case data_;
  const mesh::Q8Mesh* mesh_ = nullptr;  // view, until the end
  std::vector<std::string> remarks_;
  std::optional<ResultTables> tables_;
  std::vector<PvdEntry> fields_;
  std::vector<SeaResult> seas_;
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
  write_account();
  tables_.emplace(directory.path(), remarks_);
}

void DirectoryStore::Impl::modes(const plate::DryModes& dry) {
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
  const std::filesystem::path folder = file("fields");
  if (::mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST)
    throw FileError("cannot write to " + folder.string() + ": " + std::strerror(errno));
  for (const NodeField& field : result.fields) {
    const PvdEntry entry = entry_of(field);
    write_vtu(file(entry.file), *mesh_, field);
    fields_.push_back(entry);
  }
}

void DirectoryStore::Impl::end_seas(const SeaGridReport& grid) {
  account.sea_grid = grid;
  if (seas_.empty()) return;
  for (const SeaResult& sea : seas_)
    account.seas.push_back(
        {sea.sea, sea.mean_heading_deg, sea.significant_height, sea.share_outside, sea.grid_error});
  account.files.insert(account.files.end(), sea_table_names().begin(), sea_table_names().end());
  account.files.emplace_back("statistics.vtu");
  write_account();
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

void DirectoryStore::modes(const plate::DryModes& modes) { impl_->modes(modes); }

void DirectoryStore::frequency(const FrequencyResult& result) { impl_->frequency(result); }

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
