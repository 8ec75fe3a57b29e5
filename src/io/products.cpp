#include "io/products.hpp"

#include "io/atomic_file.hpp"
#include "io/product_names.hpp"
#include "io/relation_tables.hpp"
#include "io/sea_tables.hpp"

#include <floe/io/interchange.hpp>
#include <floe/io/stored_run.hpp>
#include <floe/mesh/mesh_hash.hpp>
#include <floe/preflight.hpp>
#include <floe/sea_statistics.hpp>

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <set>

namespace floe::io {

std::string field_file(double omega, double heading_deg) {
  return "fields/omega_" + shortest(omega) + "_heading_" + shortest(heading_deg) + ".vtu";
}

RunAccount describe_run(const Case& data, const mesh::Q8Mesh& mesh, const Estimate& plan) {
  RunAccount account;
  account.status = kRunning;
  account.mesh_hash = mesh::mesh_hash(mesh);
  account.nodes = mesh.node_count();
  account.elements = mesh.element_count();
  account.pieces = mesh.piece_count();
  account.area = mesh.area();
  account.threads = omp_get_max_threads();
  account.plan = plan;
  const plate::PlateRegions regions = plate_regions(data);
  const Preflight found =
      preflight(data, mesh, nullptr, data.plate_mesh.empty() ? &regions : nullptr);
  account.warnings = found.warnings;
  account.resolution = found.resolution;
  account.files = product_names(data.route);
  account.left_out = left_out(data.route);
  return account;
}

Products::Products(std::filesystem::path directory, nlohmann::ordered_json options,
                   const Case& data, const mesh::Q8Mesh& mesh, RunAccount described)
    : account(std::move(described)),
      directory_(std::move(directory)),
      options_(std::move(options)),
      data_(data),
      mesh_(&mesh) {
  if (!data_.title.empty()) remarks_.push_back(data_.title);
  for (const std::string& warning : account.warnings) remarks_.push_back("warning: " + warning);
  write_account();
  tables_.emplace(directory_, remarks_, data_.route);
}

void Products::write_account() const { write_file(file("run.json"), run_json(options_, account)); }

void Products::list(const std::vector<std::string>& files) {
  for (const std::string& name : files)
    if (std::find(account.files.begin(), account.files.end(), name) == account.files.end())
      account.files.push_back(name);
  write_account();
}

void Products::unlist(const std::vector<std::string>& files) {
  std::erase_if(account.files, [&](const std::string& name) {
    return std::find(files.begin(), files.end(), name) != files.end();
  });
}

void Products::modes(const plate::DryModes& dry) {
  account.dry_omega.assign(dry.omega.data(), dry.omega.data() + dry.omega.size());
  account.dry_omega_error = dry.estimated_frequency_error;
  dry_.orthonormality_error = dry.orthonormality_error;
  dry_.rigid_force_error = dry.rigid_force_error;
  write_dry_modes(directory_, remarks_, dry);
}

void Products::frequency(const FrequencyResult& result) {
  tables_->add(data_, result);
  if (!result.fields.empty()) write_fields(result);
  tables_->mark();
  account.frequencies.push_back(result.report);
  account.wavenumber.push_back(result.wavenumber);
  if (!result.report.failure.empty())
    account.warnings.push_back("no result: " + result.report.failure);
}

std::size_t Products::unsolved() const {
  return static_cast<std::size_t>(
      std::count_if(account.frequencies.begin(), account.frequencies.end(),
                    [](const FrequencyReport& report) { return !report.failure.empty(); }));
}

PvdEntry Products::entry_of(const NodeField& field) const {
  const auto heading =
      std::find(data_.heading_deg.begin(), data_.heading_deg.end(), field.heading_deg);
  return {.omega = field.omega,
          .heading = static_cast<int>(heading - data_.heading_deg.begin()),
          .file = field_file(field.omega, field.heading_deg)};
}

void Products::write_fields(const FrequencyResult& result) {
  std::vector<std::string> names;
  for (const NodeField& field : result.fields) names.push_back(entry_of(field).file);
  list(names);
  make_folder(file("fields"));
  for (const NodeField& field : result.fields) {
    const PvdEntry entry = entry_of(field);
    write_vtu(file(entry.file), *mesh_, field);
    fields_.push_back(entry);
  }
}

// As the run itself warned; once a sea
void Products::warn_of_band(const SeaResult& sea) {
  std::vector<std::string> warnings = cut_responses(sea, data_);
  if (sea.share_outside > kShareTold)
    warnings.push_back(
        fmt::format("sea {}: {:.2g} % of its m0 lie outside the frequencies that were computed "
                    "(widen sea_grid.omega)",
                    sea.sea, 100.0 * sea.share_outside));
  for (const std::string& warning : warnings) {
    const auto& told = account.warnings;
    if (std::find(told.begin(), told.end(), warning) != told.end()) continue;
    account.warnings.push_back(warning);
    remarks_.push_back("warning: " + warning);
  }
}

void Products::begin_seas(const std::vector<wave::SeaState>& seas,
                          const std::vector<double>& omega) {
  if (!data_.node_spectra || seas.empty()) return;
  list({NodeSpectraFile::kName});
  node_spectra_.emplace(directory_, *mesh_, seas, omega);
}

void Products::end_seas(const SeaGridReport& grid) {
  account.sea_grid = grid;
  const plate::PlateRegions regions = plate_regions(data_);
  account.sea_resolution = sea_resolution(data_, grid.solved, *mesh_, nullptr,
                                          data_.plate_mesh.empty() ? &regions : nullptr);
  if (seas_.empty()) return;
  for (const SeaResult& sea : seas_) {
    account.seas.push_back(summary_of(sea));
    warn_of_band(sea);
  }
  std::vector<std::string> names = sea_table_names();
  const std::vector<std::string> relations = relation_table_names(data_.relations);
  names.insert(names.end(), relations.begin(), relations.end());
  names.emplace_back("statistics.vtu");
  list(names);
  write_sea_tables(directory_, remarks_, data_, seas_);
  write_relation_tables(directory_, remarks_, data_, seas_);
  write_statistics_vtu(file("statistics.vtu"), *mesh_, seas_);
  if (node_spectra_) node_spectra_->commit();
  node_spectra_.reset();
}

// Frequencies of one sweep by processors of several kinds have other last bits
void Products::warn_of_mixture() {
  const std::set<std::string> kinds = processors_of(account);
  if (kinds.size() < 2) return;
  account.warnings.push_back(
      fmt::format("mixed processors: frequencies were solved by {} (results agree to the "
                  "tolerance, not to the bit)",
                  fmt::join(kinds, " and by ")));
}

// What the run tells about itself, and warnings where that is not good
void Products::check_results() {
  warn_of_mixture();
  std::vector<Resolution> resolution = account.resolution;
  const std::vector<Resolution>& of_seas = account.sea_resolution;
  resolution.insert(resolution.end(), of_seas.begin(), of_seas.end());
  account.checks =
      self_checks(data_, resolution, dry_, account.frequencies, account.sea_grid.solved);
  for (const std::string& warning : warnings_of(account.checks))
    account.warnings.push_back(warning);
}

void Products::end(const std::string& status) {
  mesh_ = nullptr;
  check_results();
  // What failed at its end once is not tried again
  if (tables_) {
    tables_->rollback();
    tables_->commit();
    tables_.reset();
    write_pvd(file("fields.pvd"), fields_);
    if (account.frequencies.size() > unsolved() && data_.route == SolverRoute::kModal)
      write_netcdf(StoredRun(directory_), file("result.nc"), plate::DofSet::kPlate);
  }
  account.status = status;
  write_account();
}

}  // namespace floe::io
