#pragma once

#include "io/node_spectra_file.hpp"
#include "io/result_tables.hpp"
#include "io/run_json.hpp"
#include "io/vtu.hpp"

#include <floe/analysis.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace floe::io {

/// "fields/omega_0.4_heading_30.vtu"
std::string field_file(double omega, double heading_deg);

/// What `run.json` tells of a run that begins.
RunAccount describe_run(const Case& data, const mesh::Q8Mesh& mesh, const Estimate& plan);

/// All that people and other programs read of a run, made from its results as they come: tables,
/// node fields, statistics of seas, `run.json`. Tables appear when the run ends.
class Products final {
 public:
  /// Writes `run.json`, so that every file of the run is listed before it is there. `options` is
  /// the case as `run.json` tells it; seas of `data` are not looked at. Keeps a view of `mesh`.
  Products(std::filesystem::path directory, nlohmann::ordered_json options, const Case& data,
           const mesh::Q8Mesh& mesh, RunAccount account);

  void modes(const plate::DryModes& modes);
  /// NaN in the tables, and a warning, for one that could not be solved.
  void frequency(const FrequencyResult& result);
  std::size_t unsolved() const;  ///< so far
  /// Spectra of all nodes are to come, where the case asks for them.
  void begin_seas(const std::vector<wave::SeaState>& seas, const std::vector<double>& omega);
  void node_spectrum(std::size_t result, std::size_t frequency, const VecXd& spectrum) {
    node_spectra_->put(result, frequency, spectrum);
  }
  void sea(const SeaResult& result) { seas_.push_back(result); }
  void end_seas(const SeaGridReport& grid);
  /// Completes the tables with what was finished and writes the last `run.json`.
  void end(const std::string& status);
  /// Drops the tables that have not appeared.
  void abandon() { tables_.reset(); }

  /// Lists files of the run that are about to be written; those listed already stay once.
  void list(const std::vector<std::string>& files);
  /// Takes files that were deleted off the list.
  void unlist(const std::vector<std::string>& files);

  RunAccount account;

 private:
  std::filesystem::path file(const std::string& name) const { return directory_ / name; }
  void write_account() const;
  void write_fields(const FrequencyResult& result);
  void check_results();
  void warn_of_mixture();
  void warn_of_band(const SeaResult& sea);
  PvdEntry entry_of(const NodeField& field) const;

  std::filesystem::path directory_;
  nlohmann::ordered_json options_;
  Case data_;
  const mesh::Q8Mesh* mesh_;  // view, until the end
  plate::DryModes dry_;       // what the self-checks need of them
  std::vector<std::string> remarks_;
  std::optional<ResultTables> tables_;
  std::vector<PvdEntry> fields_;
  std::vector<SeaResult> seas_;
  std::optional<NodeSpectraFile> node_spectra_;
};

}  // namespace floe::io
