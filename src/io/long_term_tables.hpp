#pragma once

#include <floe/long_term_statistics.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace floe::io {

/// Names of the tables that scatter diagrams give rise to.
const std::vector<std::string>& long_term_table_names();

/// Writes what every metre of a sea does (short_term.csv), how often which amplitudes are exceeded
/// in many years (long_term.csv) and the values of the return periods (return_values.csv);
/// `remarks` become comment lines of every table.
void write_long_term_tables(const std::filesystem::path& folder,
                            const std::vector<std::string>& remarks, const Case& data,
                            const std::vector<LongTermResult>& results);

}  // namespace floe::io
