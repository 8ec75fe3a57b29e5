#include "io/atomic_file.hpp"
#include "io/long_term_tables.hpp"
#include "io/output_directory.hpp"
#include "io/run_json.hpp"
#include "io/sea_tables.hpp"
#include "io/vtu.hpp"

#include <floe/io/statistics_store.hpp>
#include <floe/mesh/mesh_hash.hpp>

namespace floe::io {

std::vector<std::string> store_statistics(const std::filesystem::path& directory, Existing existing,
                                          const Case& data, const mesh::Q8Mesh& fluid_mesh,
                                          const SeaGridReport& grid,
                                          const std::vector<SeaResult>& results,
                                          const std::vector<LongTermResult>& long_term,
                                          const std::vector<std::string>& warnings) {
  RunAccount account;
  account.status = "complete";
  account.mesh_hash = mesh::mesh_hash(fluid_mesh);
  account.nodes = fluid_mesh.node_count();
  account.elements = fluid_mesh.element_count();
  account.pieces = fluid_mesh.piece_count();
  account.area = fluid_mesh.area();
  account.warnings = warnings;
  account.sea_grid = grid;
  for (const SeaResult& result : results) account.seas.push_back(summary_of(result));
  for (const LongTermResult& result : long_term) account.climates.push_back(summary_of(result));
  const auto add_files = [&](const std::vector<std::string>& names) {
    account.files.insert(account.files.end(), names.begin(), names.end());
  };
  if (!results.empty()) add_files(sea_table_names());
  if (!results.empty()) add_files({"statistics.vtu"});
  if (!long_term.empty()) add_files(long_term_table_names());
  add_files({"run.json"});

  std::vector<std::string> remarks;
  if (!data.title.empty()) remarks.push_back(data.title);
  for (const std::string& warning : warnings) remarks.push_back("warning: " + warning);
  OutputDirectory output(directory, existing);
  output.clear_earlier_run();
  write_file(output.path() / "run.json", run_json(data, account));
  if (!results.empty()) {
    write_sea_tables(output.path(), remarks, data, results);
    write_statistics_vtu(output.path() / "statistics.vtu", fluid_mesh, results);
  }
  if (!long_term.empty()) write_long_term_tables(output.path(), remarks, data, long_term);
  return account.files;
}

}  // namespace floe::io
