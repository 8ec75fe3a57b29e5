#pragma once

#include <floe/analysis.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace floe::io {

/// Names of the tables that seas give rise to.
const std::vector<std::string>& sea_table_names();

/// Writes spectra, moments and design values at the points, and standard deviations along the
/// lines, of all seas; `remarks` become comment lines of every table.
void write_sea_tables(const std::filesystem::path& folder, const std::vector<std::string>& remarks,
                      const Case& data, const std::vector<SeaResult>& results);

}  // namespace floe::io
