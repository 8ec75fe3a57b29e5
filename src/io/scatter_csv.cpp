#include "io/scatter_csv.hpp"

#include "io/regular_file.hpp"
#include "io/toml_section.hpp"

#include <floe/numeric/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace floe::io {
namespace {

constexpr std::uintmax_t kLargestFile = 16u << 20;
constexpr std::size_t kMostClasses = 1000;  // of heights, and of periods

struct Row {
  int line;
  std::vector<std::string_view> cells;
};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// The table's rows, without comments and empty lines
std::vector<Row> rows_of(std::string_view content) {
  if (content.starts_with("\xef\xbb\xbf")) content.remove_prefix(3);
  std::vector<Row> rows;
  for (int line = 1; !content.empty(); ++line) {
    const auto end = content.find('\n');
    std::string_view text = trimmed(content.substr(0, end));
    content.remove_prefix(end == std::string_view::npos ? content.size() : end + 1);
    if (text.empty() || text.front() == '#') continue;
    Row row{line, {}};
    for (;;) {
      const auto comma = text.find(',');
      row.cells.push_back(trimmed(text.substr(0, comma)));
      if (comma == std::string_view::npos) break;
      text.remove_prefix(comma + 1);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

// The reader of one file, which knows its name for the messages
class ScatterReader {
 public:
  explicit ScatterReader(std::string name) : name_(std::move(name)) {}

  [[noreturn]] void refuse(int line, const std::string& message) const {
    throw DataError(fmt::format("{}:{}: {}", name_, line, message));
  }

  double number(const Row& row, std::size_t column, const char* what, const char* unit) const {
    const std::string_view cell = row.cells[column];
    const auto invalid = [&](const char* required) {
      refuse(row.line, fmt::format("invalid {} = {}{} in column {} ({})", what, shown_text(cell),
                                   unit, column + 1, required));
    };
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (cell.empty()) invalid("must be a number; 0 where there is none");
    if (error != std::errc() || end != cell.data() + cell.size())
      invalid("must be a number; sums and other text are not part of the table");
    if (!std::isfinite(value) || value < 0.0) invalid("must be finite and at least 0");
    return value;
  }

  // Of heights and periods, which ascend from above 0
  void take_middle(const Row& row, std::size_t column, const char* what, const char* unit,
                   std::vector<double>& all) const {
    const double value = number(row, column, what, unit);
    if (!(value > (all.empty() ? 0.0 : all.back())))
      refuse(row.line, fmt::format("invalid {} = {}{} in column {} (must be positive and ascend; "
                                   "middles of the classes, not their edges)",
                                   what, value, unit, column + 1));
    all.push_back(value);
  }

  // A first cell such as Hs\Tp says what the columns are: it must not say something else
  void require_same_period(const Row& header, wave::PeriodType type) const {
    std::string word;
    for (const char c : std::string(header.cells.front()) + ' ') {
      if (std::isalnum(static_cast<unsigned char>(c))) {
        word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        continue;
      }
      if ((word == "tz" || word == "tp" || word == "te") && word[1] != period_name(type)[1])
        refuse(header.line, fmt::format("the table says {}, the sea file period_type = \"{}\" "
                                        "(must be the same)",
                                        shown_text(header.cells.front()), period_name(type)));
      word.clear();
    }
  }

 private:
  std::string name_;
};

}  // namespace

const char* period_name(wave::PeriodType type) {
  if (type == wave::PeriodType::kZeroCrossing) return "Tz";
  return type == wave::PeriodType::kPeak ? "Tp" : "Te";
}

wave::ScatterDiagram read_scatter_diagram(const std::filesystem::path& path,
                                          wave::PeriodType type) {
  // Split the table
  std::string content;
  try {
    content = read_regular_file(path, kLargestFile);
  } catch (const InputError& error) {
    throw DataError(error.what());
  }
  const ScatterReader reader(path.string());
  const std::vector<Row> rows = rows_of(content);
  if (rows.size() < 2 || rows.front().cells.size() < 2)
    reader.refuse(rows.empty() ? 1 : rows.front().line,
                  "not a scatter diagram (must be a row of periods and rows of a height and its "
                  "counts, with commas)");
  if (std::max(rows.size(), rows.front().cells.size()) > kMostClasses + 1)
    reader.refuse(rows.front().line,
                  fmt::format("{} rows of {} cells (must be at most {} classes each way)",
                              rows.size(), rows.front().cells.size(), kMostClasses));

  // Take over periods, heights and counts
  const Row& header = rows.front();
  reader.require_same_period(header, type);
  std::vector<double> height, period;
  for (std::size_t j = 1; j < header.cells.size(); ++j)
    reader.take_middle(header, j, "period", " s", period);
  MatXd counts(static_cast<Index>(rows.size()) - 1, static_cast<Index>(period.size()));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Row& row = rows[i];
    if (row.cells.size() != header.cells.size())
      reader.refuse(row.line, fmt::format("a row of {} cells (must be {} as in the row of periods)",
                                          row.cells.size(), header.cells.size()));
    reader.take_middle(row, 0, "height", " m", height);
    for (std::size_t j = 1; j < row.cells.size(); ++j)
      counts(static_cast<Index>(i) - 1, static_cast<Index>(j) - 1) =
          reader.number(row, j, "count", "");
  }
  if (!(counts.sum() > 0.0) || !std::isfinite(counts.sum()))
    reader.refuse(header.line,
                  fmt::format("the counts add up to {} (must be positive)", counts.sum()));
  return wave::scatter_diagram(std::move(height), std::move(period), type, counts);
}

}  // namespace floe::io
