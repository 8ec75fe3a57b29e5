#include "io/atomic_file.hpp"
#include "io/case_json.hpp"
#include "io/long_term_tables.hpp"
#include "io/node_spectra_file.hpp"
#include "io/output_directory.hpp"
#include "io/relation_tables.hpp"
#include "io/run_json.hpp"
#include "io/sea_tables.hpp"
#include "io/vtu.hpp"

#include <floe/io/statistics_store.hpp>
#include <floe/mesh/mesh_hash.hpp>

#include <optional>

namespace floe::io {

namespace {

RunAccount account_of(const mesh::Q8Mesh& mesh, const SeaGridReport& grid,
                      const std::vector<SeaResult>& results,
                      const std::vector<LongTermResult>& long_term,
                      const std::vector<std::string>& warnings) {
  RunAccount account;
  account.status = "complete";
  account.mesh_hash = mesh::mesh_hash(mesh);
  account.nodes = mesh.node_count();
  account.elements = mesh.element_count();
  account.pieces = mesh.piece_count();
  account.area = mesh.area();
  account.warnings = warnings;
  account.sea_grid = grid;
  for (const SeaResult& result : results) account.seas.push_back(summary_of(result));
  for (const LongTermResult& result : long_term) account.climates.push_back(summary_of(result));
  return account;
}

}  // namespace

struct StatisticsStore::Impl {
  Impl(const std::filesystem::path& directory, Existing existing, const Case& given,
       const mesh::Q8Mesh& fluid_mesh, const SeaGridReport& frequencies)
      : data(given), mesh(fluid_mesh), grid(frequencies), output(directory, existing) {
    output.clear_earlier_run();
    if (data.node_spectra && !data.seas.empty())
      node_spectra.emplace(output.path(), mesh, data.seas, grid.omega);
  }

  Case data;
  mesh::Q8Mesh mesh;
  SeaGridReport grid;
  OutputDirectory output;
  std::optional<NodeSpectraFile> node_spectra;
};

StatisticsStore::StatisticsStore(const std::filesystem::path& directory, Existing existing,
                                 const Case& data, const mesh::Q8Mesh& fluid_mesh,
                                 const SeaGridReport& grid)
    : impl_(std::make_unique<Impl>(directory, existing, data, fluid_mesh, grid)) {}

StatisticsStore::~StatisticsStore() = default;

NodeSpectrumSink StatisticsStore::node_spectra(std::size_t frequency) {
  if (!impl_->node_spectra) return {};
  return [this, frequency](std::size_t result, const VecXd& spectrum) {
    impl_->node_spectra->put(result, frequency, spectrum);
  };
}

std::vector<std::string> StatisticsStore::finish(const std::vector<SeaResult>& results,
                                                 const std::vector<LongTermResult>& long_term,
                                                 const std::vector<std::string>& warnings) {
  const Case& data = impl_->data;
  RunAccount account = account_of(impl_->mesh, impl_->grid, results, long_term, warnings);
  const auto add_files = [&](const std::vector<std::string>& names) {
    account.files.insert(account.files.end(), names.begin(), names.end());
  };
  if (!results.empty()) add_files(sea_table_names());
  if (!results.empty()) add_files(relation_table_names(data.relations));
  if (!results.empty()) add_files({"statistics.vtu"});
  if (impl_->node_spectra) add_files({NodeSpectraFile::kName});
  if (!long_term.empty()) add_files(long_term_table_names());
  add_files({"run.json"});

  std::vector<std::string> remarks;
  if (!data.title.empty()) remarks.push_back(data.title);
  for (const std::string& warning : warnings) remarks.push_back("warning: " + warning);
  const std::filesystem::path& folder = impl_->output.path();
  write_file(folder / "run.json", run_json(case_json(data), account));
  if (!results.empty()) {
    write_sea_tables(folder, remarks, data, results);
    write_relation_tables(folder, remarks, data, results);
    write_statistics_vtu(folder / "statistics.vtu", impl_->mesh, results);
  }
  if (impl_->node_spectra) impl_->node_spectra->commit();
  if (!long_term.empty()) write_long_term_tables(folder, remarks, data, long_term);
  return account.files;
}

}  // namespace floe::io
