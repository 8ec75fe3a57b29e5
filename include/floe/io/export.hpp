#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace floe::io {

/// What an export found and made.
struct Exported {
  std::vector<std::string> files;  ///< all files of the run, relative to its directory
  std::size_t planned = 0;         ///< frequencies of the case, or of the shard
  std::vector<double> missing;     ///< those that were not tried [rad/s]
  std::string unsolved;            ///< describe_unsolved of those that could not be solved
  bool seas_missing = false;       ///< seas are asked for and not finished
  /// Spectra of all nodes are asked for and not there; records do not hold them.
  bool node_spectra_missing = false;
  bool complete() const { return missing.empty() && unsolved.empty() && !seas_missing; }
};

/// Makes all products of a run anew from its records, but the spectra of all nodes, which stay
/// where they are; solves nothing. A run that is not finished gives the products of what is. Throws
/// StoreError when the directory holds no run or a record is damaged, BusyError while a run holds
/// it, FileError.
Exported export_run(const std::filesystem::path& directory);

}  // namespace floe::io
