#include "mesh/gmsh_scanner.hpp"

#include <floe/numeric/error.hpp>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

namespace floe::mesh {
namespace {

static_assert(std::endian::native == std::endian::little, "binary meshes are read as they lie");

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

}  // namespace

GmshScanner::GmshScanner(std::string_view bytes, std::string file_name)
    : bytes_(bytes), file_name_(std::move(file_name)) {}

bool GmshScanner::at_end() {
  while (position_ < bytes_.size() && is_blank(bytes_[position_]))
    if (bytes_[position_++] == '\n') ++line_;
  return position_ == bytes_.size();
}

std::string_view GmshScanner::word(const char* what) {
  if (at_end()) fail(std::string("file ends where ") + what + " must stand");
  const std::size_t start = position_;
  while (position_ < bytes_.size() && !is_blank(bytes_[position_])) ++position_;
  return bytes_.substr(start, position_ - start);
}

std::string GmshScanner::quoted(const char* what) {
  if (at_end() || bytes_[position_] != '"')
    fail(std::string("invalid ") + what + " (must stand in double quotes)");
  const std::size_t start = position_ + 1, end = bytes_.find_first_of("\"\n", start);
  if (end == std::string_view::npos || bytes_[end] != '"')
    fail(std::string("invalid ") + what + " (must end with a double quote)");
  position_ = end + 1;
  return std::string(bytes_.substr(start, end - start));
}

void GmshScanner::expect(std::string_view expected) {
  const std::string name(expected);
  const std::string_view found = word(name.c_str());
  if (found != expected) fail("found '" + printable(found) + "' (must be " + name + ")");
}

void GmshScanner::end_line() {
  while (position_ < bytes_.size() && bytes_[position_] != '\n')
    if (!is_blank(bytes_[position_++])) fail("text where the line must end");
  if (position_ == bytes_.size()) fail("file ends within a section");
  ++position_;
  ++line_;
}

void GmshScanner::skip_behind(const std::string& end) {
  for (std::size_t at = bytes_.find(end, position_); at != std::string_view::npos;
       at = bytes_.find(end, at + 1)) {
    const std::size_t behind = at + end.size();
    const bool starts_line = bytes_[at - 1] == '\n';
    if (!starts_line || (behind < bytes_.size() && !is_blank(bytes_[behind]))) continue;
    line_ += static_cast<std::size_t>(
        std::count(bytes_.begin() + static_cast<std::ptrdiff_t>(position_),
                   bytes_.begin() + static_cast<std::ptrdiff_t>(behind), '\n'));
    position_ = behind;
    return;
  }
  fail("section without " + end);
}

template <typename Number>
Number GmshScanner::parse(const char* what) {
  const std::string_view text = word(what);
  const char* first = text.data() + (text.front() == '+' && text.size() > 1 ? 1 : 0);
  const char* last = text.data() + text.size();
  Number value{};
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || end != last)
    fail(std::string("invalid ") + what + " = '" + printable(text) + "' (must be " +
         (std::is_integral_v<Number> ? "an integer)" : "a finite number)"));
  return value;
}

template <typename Number>
Number GmshScanner::copy(const char* what) {
  if (bytes_.size() - position_ < sizeof(Number))
    fail(std::string("file ends where ") + what + " must stand");
  Number value;
  std::memcpy(&value, bytes_.data() + position_, sizeof(Number));
  position_ += sizeof(Number);
  return value;
}

std::int64_t GmshScanner::text_integer(const char* what) { return parse<std::int64_t>(what); }

std::int64_t GmshScanner::integer(const char* what) {
  return binary_ ? copy<std::int32_t>(what) : parse<std::int64_t>(what);
}

std::int64_t GmshScanner::size(const char* what) {
  const std::int64_t value = binary_ ? copy<std::int64_t>(what) : parse<std::int64_t>(what);
  if (value < 0) fail(what, value, "must be 0 to 2^63 - 1");
  return value;
}

double GmshScanner::real(const char* what) {
  const double value = binary_ ? copy<double>(what) : parse<double>(what);
  if (!std::isfinite(value)) fail(std::string("invalid ") + what + " (must be a finite number)");
  return value;
}

void GmshScanner::demand_room(std::int64_t count, std::int64_t bytes_each, const char* what) const {
  const std::int64_t room = static_cast<std::int64_t>(bytes_.size() - position_) / bytes_each;
  if (count < 0 || count > room)
    fail(what, count, "must be 0 to " + std::to_string(room) + ": no more fit in the file");
}

void GmshScanner::fail(const std::string& message) const {
  throw MeshError(file_name_ +
                  (binary_ ? ": byte " + std::to_string(position_) : ":" + std::to_string(line_)) +
                  ": " + message);
}

void GmshScanner::fail(const char* what, std::int64_t value, const std::string& required) const {
  fail(std::string("invalid ") + what + " = " + std::to_string(value) + " (" + required + ")");
}

std::string printable(std::string_view text) {
  std::string safe(text.substr(0, 40));
  for (char& c : safe)
    if (c < ' ' || c > '~') c = '?';
  return safe;
}

}  // namespace floe::mesh
