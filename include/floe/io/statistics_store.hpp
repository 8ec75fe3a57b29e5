#pragma once

#include <floe/io/directory_store.hpp>
#include <floe/long_term_statistics.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace floe::io {

/// Statistics of new seas from a stored run, as files in a directory of their own: the tables of
/// seas and `statistics.vtu`, the tables of scatter diagrams, each where there are any, and
/// `run.json`. `data` is the run's case with the new seas. Throws as DirectoryStore. Returns the
/// files' names.
std::vector<std::string> store_statistics(const std::filesystem::path& directory, Existing existing,
                                          const Case& data, const mesh::Q8Mesh& fluid_mesh,
                                          const SeaGridReport& grid,
                                          const std::vector<SeaResult>& results,
                                          const std::vector<LongTermResult>& long_term,
                                          const std::vector<std::string>& warnings);

}  // namespace floe::io
