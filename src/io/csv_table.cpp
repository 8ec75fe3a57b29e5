#include "io/csv_table.hpp"

#include <floe/numeric/error.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace floe::io {
namespace {

// Comment lines stay single lines whatever a title holds
std::string single_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  return text;
}

// Cells with special characters are quoted, quotes doubled (RFC 4180)
std::string quoted_if_needed(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + '"';
}

}  // namespace

std::string shortest(double value) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value == 0.0 ? 0.0 : value);
  return {text.data(), end.ptr};
}

CsvTable::CsvTable(const std::filesystem::path& path, const std::vector<std::string>& comments,
                   std::vector<std::string> columns)
    : file_(path), columns_(std::move(columns)) {
  for (const std::string& comment : comments) file_.write("# " + single_line(comment) + "\n");
  for (const std::string& column : columns_) cell(column);
  end_row();
  mark();
}

CsvTable& CsvTable::operator<<(double value) {
  if (unknown_ && std::isnan(value)) {
    cell("nan");
    return *this;
  }
  FLOE_VALIDATE_AS(ConvergenceError, std::isfinite(value),
                   "invalid " << columns_[std::min(filled_, columns_.size() - 1)] << " = " << value
                              << " in " << file_.path().filename().string() << " after \"" << row_
                              << "\" (must be finite)");
  cell(shortest(value));
  return *this;
}

CsvTable& CsvTable::operator<<(Index value) {
  cell(std::to_string(value));
  return *this;
}

CsvTable& CsvTable::operator<<(std::string_view text) {
  cell(quoted_if_needed(text));
  return *this;
}

CsvTable& CsvTable::operator<<(const Complex& value) {
  return *this << value.real() << value.imag() << std::abs(value);
}

void CsvTable::end_row() {
  FLOE_EXPECT(filled_ == columns_.size());
  file_.write(row_ + "\n");
  row_.clear();
  filled_ = 0;
}

void CsvTable::cell(std::string_view text) {
  if (filled_++ > 0) row_ += ',';
  row_ += text;
}

}  // namespace floe::io
