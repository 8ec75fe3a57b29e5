#pragma once

#if __has_include("test_paths.hpp")
#include "test_paths.hpp"
#endif

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Reading of the tables in tests/data: commas, one header line, lines that start with `#` skipped.
namespace floe::test {

/// A table of text cells with named columns.
class CsvTable {
 public:
  CsvTable(std::vector<std::string> names, std::vector<std::vector<std::string>> rows)
      : names_(std::move(names)), rows_(std::move(rows)) {}

  std::size_t row_count() const { return rows_.size(); }
  const std::vector<std::string>& names() const { return names_; }

  /// The column of that name, one entry a row. Throws std::runtime_error if there is none.
  std::vector<std::string> strings(std::string_view name) const {
    const std::size_t column = index(name);
    std::vector<std::string> values;
    for (const auto& row : rows_) values.push_back(row[column]);
    return values;
  }

  /// The same as numbers. Throws std::runtime_error if a cell is not wholly a number.
  std::vector<double> numbers(std::string_view name) const {
    std::vector<double> values;
    for (const std::string& cell : strings(name)) values.push_back(number(cell, name));
    return values;
  }

  /// The rows whose cell in column `name` is `value` (compared as text).
  CsvTable where(std::string_view name, std::string_view value) const {
    return select(name, [&](const std::string& cell) { return cell == value; });
  }

  /// The rows whose cell in column `name` is the number `value`.
  CsvTable where(std::string_view name, double value) const {
    return select(name, [&](const std::string& cell) { return number(cell, name) == value; });
  }

 private:
  std::size_t index(std::string_view name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) throw std::runtime_error("no column " + std::string(name));
    return static_cast<std::size_t>(found - names_.begin());
  }

  static double number(const std::string& cell, std::string_view name) {
    std::size_t used = 0;
    double value = 0.0;
    try {
      value = std::stod(cell, &used);
    } catch (const std::logic_error&) {
      used = cell.size() + 1;
    }
    if (used != cell.size())
      throw std::runtime_error("not a number in column " + std::string(name) + ": " + cell);
    return value;
  }

  template <class Predicate>
  CsvTable select(std::string_view name, const Predicate& keep) const {
    const std::size_t column = index(name);
    std::vector<std::vector<std::string>> rows;
    for (const auto& row : rows_)
      if (keep(row[column])) rows.push_back(row);
    return CsvTable(names_, std::move(rows));
  }

  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
};

/// Reads a table. Throws std::runtime_error when the file cannot be read, has no header, or a row
/// has another number of cells than the header.
inline CsvTable read_csv(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  std::vector<std::vector<std::string>> lines;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    std::vector<std::string>& cells = lines.emplace_back();
    for (std::size_t start = 0; start <= line.size();) {
      const std::size_t comma = std::min(line.find(',', start), line.size());
      cells.push_back(line.substr(start, comma - start));
      start = comma + 1;
    }
    if (cells.size() != lines.front().size())
      throw std::runtime_error("ragged row in " + path.string() + ": " + line);
  }
  if (lines.empty()) throw std::runtime_error("no header in " + path.string());
  std::vector<std::string> names = std::move(lines.front());
  lines.erase(lines.begin());
  return CsvTable(std::move(names), std::move(lines));
}

#ifdef FLOE_TEST_DATA
/// Reads a table of tests/data by its file name.
inline CsvTable read_reference(const std::string& file) {
  return read_csv(std::filesystem::path(FLOE_TEST_DATA) / file);
}
#endif

}  // namespace floe::test
