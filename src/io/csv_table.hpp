#pragma once

#include "io/atomic_file.hpp"

#include <floe/numeric/types.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace floe::io {

/// Shortest text that reads back as the same number; -0 becomes 0.
std::string shortest(double value);

/// A table with commas, no blanks, shortest round-trip numbers, `#` comment lines before the
/// header. Appears under its name only when committed. A number that is not finite throws
/// ConvergenceError naming file and column, unless it is said to be unknown.
class CsvTable final {
 public:
  CsvTable(const std::filesystem::path& path, const std::vector<std::string>& comments,
           std::vector<std::string> columns);

  CsvTable& operator<<(double value);
  CsvTable& operator<<(Index value);
  CsvTable& operator<<(std::string_view text);
  /// Real part, imaginary part, absolute value: three cells.
  CsvTable& operator<<(const Complex& value);
  void end_row();
  /// From now on NaN is written where it stands, or no longer.
  void let_unknown(bool let) { unknown_ = let; }

  void mark() { file_.mark(); }
  void rollback() { file_.rollback(); }
  void commit() { file_.commit(); }

 private:
  void cell(std::string_view text);

  AtomicFile file_;
  std::vector<std::string> columns_;
  std::string row_;
  std::size_t filled_ = 0;
  bool unknown_ = false;
};

}  // namespace floe::io
