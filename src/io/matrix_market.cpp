#include "io/matrix_market.hpp"

#include <floe/numeric/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <vector>

namespace floe::io {
namespace {

/// Words and numbers of a file, line by line.
class MatrixText {
 public:
  MatrixText(std::string_view text, std::string file_name)
      : rest_(text), file_name_(std::move(file_name)) {}

  /// The first line; throws unless it is the wanted kind of matrix. True if symmetric.
  bool read_header(const std::string& format) {
    const std::string header = lower(take_line());
    if (!header.starts_with("%%matrixmarket"))
      fail("no Matrix Market file (must begin with %%MatrixMarket)");
    std::vector<std::string> words;
    for (std::string_view line = header; !next_word(line).empty(); drop_word(line))
      words.emplace_back(next_word(line));
    if (words.size() != 5 || words[1] != "matrix" || words[2] != format ||
        (words[3] != "real" && words[3] != "double" && words[3] != "integer") ||
        (words[4] != "general" && words[4] != "symmetric"))
      fail(fmt::format("found '{}' (must be %%MatrixMarket matrix {} real general or symmetric)",
                       header.substr(0, 80), format));
    return words[4] == "symmetric";
  }

  /// The next line that is no comment and not blank; throws at the end of the file.
  void next_line() {
    do {
      if (rest_.empty()) fail("the file ends too early");
      line_ = take_line();
    } while (next_word(line_).empty() || line_[line_.find_first_not_of(" \t\r")] == '%');
  }
  template <typename Number>
  Number number(const char* what) {
    std::string_view word = next_word(line_);
    if (word.starts_with('+')) word.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc() || end != word.data() + word.size())
      fail(fmt::format("invalid {} = '{}' (must be {})", what, word.substr(0, 40),
                       std::is_integral_v<Number> ? "a whole number" : "a finite number"));
    drop_word(line_);
    return value;
  }
  double finite(const char* what) {
    const auto value = number<double>(what);
    if (!std::isfinite(value)) fail(fmt::format("invalid {} (must be a finite number)", what));
    return value;
  }
  void end_line() {
    if (!next_word(line_).empty()) fail("text where the line must end");
  }
  void end_file() {
    while (!rest_.empty()) {
      line_ = take_line();
      if (!next_word(line_).empty()) fail("text after the last entry");
    }
  }
  /// Throws unless `count` entries of two bytes each, at least, can follow.
  void demand_room(Index count) const {
    if (count < 0 || count > std::ssize(rest_) / 2 + 1)
      fail(fmt::format("invalid number of entries = {} (must fit in the file)", count));
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw MeshError(fmt::format("{}:{}: {}", file_name_, number_, message));
  }

 private:
  static std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
  }
  static std::string_view next_word(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return line.substr(first, line.find_first_of(" \t\r", first) - first);
  }
  static void drop_word(std::string_view& line) {
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(" \t\r")));
    line.remove_prefix(std::min(line.size(), line.find_first_of(" \t\r")));
  }
  std::string_view take_line() {
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++number_;
    return line;
  }

  std::string_view rest_, line_;
  std::string file_name_;
  Index number_ = 0;
};

struct Size {
  Index rows = 0;
  Index columns = 0;
};

Size read_size(MatrixText& text) {
  constexpr Index kLargest = Index{1} << 40;
  text.next_line();
  const Size size{text.number<Index>("number of rows"), text.number<Index>("number of columns")};
  if (size.rows < 1 || size.columns < 1 || size.rows > kLargest || size.columns > kLargest)
    text.fail(fmt::format("invalid size = {} × {} (must be positive)", size.rows, size.columns));
  return size;
}

}  // namespace

SparseMatrix parse_sparse_matrix(std::string_view bytes, const std::string& file_name) {
  MatrixText text(bytes, file_name);
  const bool symmetric = text.read_header("coordinate");
  const Size size = read_size(text);
  if (symmetric && size.rows != size.columns)
    text.fail(fmt::format("invalid size = {} × {} (must be square where the matrix is symmetric)",
                          size.rows, size.columns));
  const auto count = text.number<Index>("number of entries");
  text.end_line();
  text.demand_room(count);
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  entries.reserve(static_cast<std::size_t>(symmetric ? 2 * count : count));
  for (Index k = 0; k < count; ++k) {
    text.next_line();
    const auto i = text.number<Index>("row"), j = text.number<Index>("column");
    if (i < 1 || i > size.rows || j < 1 || j > size.columns)
      text.fail(fmt::format("invalid place = {}, {} (must be 1 to {}, 1 to {})", i, j, size.rows,
                            size.columns));
    const double value = text.finite("entry");
    text.end_line();
    entries.emplace_back(i - 1, j - 1, value);
    if (symmetric && i != j) entries.emplace_back(j - 1, i - 1, value);
  }
  text.end_file();
  // NOTE: rows as many as the file could name are no reason to allocate: a matrix has an entry a
  // column, or it is refused for its size later on
  if (size.columns > 2 * count + 1 || size.rows > 2 * count + 1)
    text.fail(fmt::format("invalid size = {} × {} (must have an entry in each row, found {})",
                          size.rows, size.columns, count));
  SparseMatrix matrix(size.rows, size.columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  if (matrix.nonZeros() != std::ssize(entries))
    text.fail("an entry stands twice (must stand once)");
  return matrix;
}

MatXd parse_dense_matrix(std::string_view bytes, const std::string& file_name) {
  MatrixText text(bytes, file_name);
  if (text.read_header("array")) text.fail("found a symmetric array (must be general)");
  const Size size = read_size(text);
  text.end_line();
  if (size.columns > std::ssize(bytes) || size.rows > std::ssize(bytes) / size.columns)
    text.fail(
        fmt::format("invalid size = {} × {} (must fit in the file)", size.rows, size.columns));
  MatXd matrix(size.rows, size.columns);
  for (Index j = 0; j < size.columns; ++j)
    for (Index i = 0; i < size.rows; ++i) {
      text.next_line();
      matrix(i, j) = text.finite("entry");
      text.end_line();
    }
  text.end_file();
  return matrix;
}

}  // namespace floe::io
