#include "io/toml_characters.hpp"

#include <fmt/format.h>

#include <string_view>

namespace floe::io {
namespace {

// Goes through a file and knows whether it is in a comment or in a text of which quotes
class Scanner {
 public:
  Scanner(std::string_view rest, const CaseSource& source) : rest_(rest), source_(source) {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);  // byte order mark
  }

  void run() {
    while (!rest_.empty()) {
      require_allowed(static_cast<unsigned char>(rest_.front()));
      if (comment_ || quotes_.empty())
        step_outside();
      else
        step_inside();
    }
  }

 private:
  void step_outside() {
    if (comment_ || rest_.front() == '\n') {
      comment_ = rest_.front() != '\n';
    } else if (rest_.front() == '#') {
      comment_ = true;
    } else {
      for (const char* quotes : {"\"\"\"", "'''", "\"", "'"})
        if (rest_.starts_with(quotes)) {
          quotes_ = quotes;
          return advance(quotes_.size());
        }
    }
    advance(1);
  }

  void step_inside() {
    if (quotes_.front() == '"' && rest_.front() == '\\') return advance(2);
    const bool broken = quotes_.size() == 1 && rest_.front() == '\n';  // the parser will say so
    const bool closed = rest_.starts_with(quotes_);
    const std::size_t length = closed ? quotes_.size() : 1;
    if (broken || closed) quotes_ = {};
    advance(length);
  }

  void require_allowed(unsigned char c) const {
    const bool control = (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7f;
    if (control) refuse(fmt::format("control character 0x{:02x}", c));
    if (c >= 0x80 && !comment_ && quotes_.empty())
      refuse("letter beyond ASCII outside of quotes and comments");
  }

  [[noreturn]] void refuse(const std::string& what) const {
    toml::source_region place;
    place.begin = {line_, column_};
    source_.refuse(place, "not valid TOML: " + what);
  }

  void advance(std::size_t count) {
    for (; count > 0 && !rest_.empty(); --count) {
      const char c = rest_.front();
      rest_.remove_prefix(1);
      if (c == '\n') {
        ++line_;
        column_ = 1;
      } else if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) {
        ++column_;  // characters, not bytes
      }
    }
  }

  std::string_view rest_, quotes_;
  const CaseSource& source_;  // view
  bool comment_ = false;
  toml::source_index line_ = 1, column_ = 1;
};

}  // namespace

void require_toml_characters(const std::string& content, const CaseSource& source) {
  Scanner(content, source).run();
}

}  // namespace floe::io
