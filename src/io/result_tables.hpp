#pragma once

#include "io/csv_table.hpp"

#include <floe/analysis.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace floe::io {

/// The tables that grow with every frequency: transfer functions at points, along lines and on the
/// water, hydrodynamic coefficients, exciting forces.
class ResultTables final {
 public:
  /// Those that this route knows; `remarks` become comment lines of every table.
  ResultTables(const std::filesystem::path& folder, const std::vector<std::string>& remarks,
               SolverRoute route);

  /// Appends one frequency; rows by rising frequency, then heading, then as in the case. NaN in one
  /// that could not be solved.
  void add(const Case& data, const FrequencyResult& result);
  /// Counts all rows so far as good.
  void mark();
  /// Drops the rows since the last mark.
  void rollback();
  void commit();

 private:
  template <typename Function>
  void each(Function function) {
    for (CsvTable* table : {&points_, &lines_, &quantities_, &waves_}) function(*table);
    for (std::optional<CsvTable>* table : {&coefficients_, &forces_})
      if (*table) function(**table);
  }

  CsvTable points_, lines_, quantities_, waves_;
  std::optional<CsvTable> coefficients_, forces_;  // of modes
};

/// Writes `dry_modes.csv`.
void write_dry_modes(const std::filesystem::path& folder, const std::vector<std::string>& remarks,
                     const plate::DryModes& modes);

}  // namespace floe::io
