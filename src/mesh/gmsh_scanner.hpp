#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace floe::mesh {

/// Reads words and numbers from the bytes of a .msh file, as text or as little-endian binary, and
/// never beyond their end. Whatever is wrong becomes a MeshError that names the file and the line
/// (binary: the byte).
class GmshScanner {
 public:
  GmshScanner(std::string_view bytes, std::string file_name);

  /// Numbers are binary from now on; words and counts in text stay text.
  void set_binary() { binary_ = true; }
  bool binary() const { return binary_; }

  /// Skips blanks; true if nothing is left.
  bool at_end();
  /// The next run of non-blank characters.
  std::string_view word(const char* what);
  /// The text between two double quotes of a line.
  std::string quoted(const char* what);
  /// Takes the word `expected`, or fails.
  void expect(std::string_view expected);
  /// Ends a line of text, after which binary numbers may start.
  void end_line();
  /// Skips to behind the word `end`.
  void skip_behind(const std::string& end);

  /// An integer in text, whatever the mode.
  std::int64_t text_integer(const char* what);
  /// An integer of 4 bytes, or one of 8 that is not negative ("size").
  std::int64_t integer(const char* what);
  std::int64_t size(const char* what);
  /// A finite number.
  double real(const char* what);

  /// Demands that `count` things of `bytes_each` bytes, at least, can follow.
  void demand_room(std::int64_t count, std::int64_t bytes_each, const char* what) const;

  [[noreturn]] void fail(const std::string& message) const;
  /// Fails with "invalid `what` = `value` (`required`)".
  [[noreturn]] void fail(const char* what, std::int64_t value, const std::string& required) const;

 private:
  template <typename Number>
  Number parse(const char* what);
  template <typename Number>
  Number copy(const char* what);

  std::string_view bytes_;
  std::string file_name_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
  bool binary_ = false;
};

/// A piece of foreign text as it may stand in a message: short, without control characters.
std::string printable(std::string_view text);

}  // namespace floe::mesh
