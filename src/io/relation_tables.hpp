#pragma once

#include <floe/analysis.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace floe::io {

/// Names of the tables that the relations of a case give rise to; none where it has none.
std::vector<std::string> relation_table_names(const SeaRelations& relations);

/// Writes cross-spectra and covariances of pairs, and combinations with their spectra, of all seas;
/// `remarks` become comment lines of every table.
void write_relation_tables(const std::filesystem::path& folder,
                           const std::vector<std::string>& remarks, const Case& data,
                           const std::vector<SeaResult>& results);

}  // namespace floe::io
