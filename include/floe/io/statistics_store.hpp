#pragma once

#include <floe/io/directory_store.hpp>
#include <floe/long_term_statistics.hpp>
#include <floe/sea_statistics.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace floe::io {

/// Statistics of new seas from a stored run, as files in a directory of their own: the tables of
/// seas and `statistics.vtu`, the tables of scatter diagrams, each where there are any, spectra at
/// all nodes where the case asks for them, and `run.json`.
class StatisticsStore final {
 public:
  /// `data` is the run's case with the new seas; mesh and grid those of the run. Throws as
  /// DirectoryStore.
  StatisticsStore(const std::filesystem::path& directory, Existing existing, const Case& data,
                  const mesh::Q8Mesh& fluid_mesh, const SeaGridReport& grid);
  ~StatisticsStore();

  /// Where the spectra at all nodes of a frequency go; empty if the case does not ask for them.
  NodeSpectrumSink node_spectra(std::size_t frequency);

  /// Writes the rest. Returns the files' names.
  std::vector<std::string> finish(const std::vector<SeaResult>& results,
                                  const std::vector<LongTermResult>& long_term,
                                  const std::vector<std::string>& warnings);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace floe::io
