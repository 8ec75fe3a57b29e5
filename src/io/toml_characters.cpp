#include "io/toml_characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace floe::io {
namespace {

bool starts_a_name(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '"' || c == '\'';
}

// Goes through a file and knows whether it is in a comment or in a text of which quotes, and which
// brackets are open
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
    const char c = rest_.front();
    if (comment_ || c == '\n') {
      comment_ = c != '\n';
      line_begins_ = !comment_;
      header_ = false;
    } else if (c == '#') {
      comment_ = true;
    } else if (c == '"' || c == '\'') {
      return open_text();
    } else {
      step_brackets(c);
    }
    before_ = c;
    advance(1);
  }

  void open_text() {
    if (std::string_view(" \t\r\n=[{,.").find(before_) == std::string_view::npos)
      refuse("quote within a word");
    for (const char* quotes : {"\"\"\"", "'''", "\"", "'"})
      if (quotes_.empty() && rest_.starts_with(quotes)) quotes_ = quotes;
    line_begins_ = false;
    before_ = rest_.front();
    advance(quotes_.size());
  }

  // A line that begins with a bracket outside of arrays is the header of a section
  void step_brackets(char c) {
    if (c == '[' && line_begins_ && open_.empty()) {
      header_ = true;
      require_section_name();
    }
    line_begins_ = line_begins_ && (c == ' ' || c == '\t' || c == '\r');
    if (header_) return;
    if (c == '[' || c == '{') open_ += c;
    if (c != ']' && c != '}') return;
    if (open_.empty() || open_.back() != (c == ']' ? '[' : '{'))
      refuse(fmt::format("{} without {} before it", c, c == ']' ? '[' : '{'));
    open_.pop_back();
  }

  void require_section_name() const {
    const bool twice = rest_.starts_with("[[");
    std::string_view name = rest_.substr(twice ? 2 : 1);
    name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
    if (name.empty() || starts_a_name(name.front()) || name.front() == ']') return;
    if (!twice && name.front() == '[') return;  // the parser says that brackets stand together
    const auto c = static_cast<unsigned char>(name.front());
    if ((c < 0x20 && c != '\n' && c != '\r') || c >= 0x7f)
      return;  // will be refused where it stands
    refuse("name of a section that begins with neither a letter, a digit, _, - nor a quote");
  }

  void step_inside() {
    if (quotes_.front() == '"' && rest_.front() == '\\') {
      if (rest_.size() > 1 && static_cast<unsigned char>(rest_[1]) >= 0x80)
        refuse("letter beyond ASCII behind a backslash");
      return advance(2);
    }
    const bool broken = quotes_.size() == 1 && rest_.front() == '\n';  // the parser will say so
    // Three quotes that close may follow one or two that do not
    const bool closed = rest_.starts_with(quotes_) &&
                        (quotes_.size() == 1 || !rest_.substr(1).starts_with(quotes_));
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
  bool comment_ = false, line_begins_ = true, header_ = false;
  std::string open_;    // brackets, outermost first
  char before_ = '\n';  // the character outside of texts that came last
  toml::source_index line_ = 1, column_ = 1;
};

}  // namespace

void require_toml_characters(const std::string& content, const CaseSource& source) {
  Scanner(content, source).run();
}

}  // namespace floe::io
