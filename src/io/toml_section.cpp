#include "io/toml_section.hpp"

#include <floe/io/case_file.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace floe::io {
namespace {

// More than this many frequencies or headings are a slip of the pen
constexpr int kMostNumbers = 100'000;

constexpr NumberRule kAnyFinite{"m", "must be finite", [](double x) { return std::isfinite(x); }};

std::string with_unit(const std::string& value, const NumberRule& rule) {
  return *rule.unit ? value + " " + rule.unit : value;
}

}  // namespace

std::string CaseSource::place(const toml::source_region& region) const {
  return fmt::format("{}:{}:{}: ", name, region.begin.line, region.begin.column);
}

void CaseSource::refuse(const toml::source_region& region, const std::string& message) const {
  throw InputError(place(region) + message);
}

bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

std::string shown_text(std::string_view text) {
  constexpr std::size_t kShown = 60;
  std::string shortened(text.substr(0, kShown));
  for (char& c : shortened)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return '"' + shortened + (text.size() > kShown ? "…\"" : "\"");
}

std::string shown(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return "a list";
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto* text = node.as_string()) return shown_text(text->get());
  return "a date or time";
}

double checked_number(const toml::node& node, const std::string& name, const NumberRule& rule,
                      const CaseSource& source) {
  double value = 0.0;
  if (const auto* number = node.as_floating_point())
    value = number->get();
  else if (const auto* whole = node.as_integer())
    value = static_cast<double>(whole->get());
  else
    source.refuse(node.source(), fmt::format("invalid {} = {} (must be a number{}{})", name,
                                             shown(node), *rule.unit ? " in " : "", rule.unit));
  if (std::fpclassify(value) == FP_SUBNORMAL)
    source.refuse(node.source(),
                  fmt::format("invalid {} = {} ({}; smaller than 2.3e-308 is not a usable number)",
                              name, with_unit(shown(node), rule), rule.required));
  if (std::isnan(value) || !rule.accepts(value))
    source.refuse(node.source(), fmt::format("invalid {} = {} ({})", name,
                                             with_unit(shown(node), rule), rule.required));
  return value == 0.0 ? 0.0 : value;  // -0.0 counts as 0
}

std::pair<double, double> checked_point(const toml::node& node, const std::string& name,
                                        const CaseSource& source) {
  const toml::array* pair = node.as_array();
  if (!pair || pair->size() != 2)
    source.refuse(node.source(),
                  fmt::format("invalid {} = {} (must be two numbers [x, y] in m)", name,
                              pair ? fmt::format("a list of {}", pair->size()) : shown(node)));
  return {checked_number((*pair)[0], name + "[0]", kAnyFinite, source),
          checked_number((*pair)[1], name + "[1]", kAnyFinite, source)};
}

std::vector<const toml::key*> keys_in_file_order(const toml::table& table) {
  std::vector<const toml::key*> keys;
  for (const auto& entry : table) keys.push_back(&entry.first);
  std::stable_sort(keys.begin(), keys.end(), [](const toml::key* a, const toml::key* b) {
    const auto &p = a->source().begin, &q = b->source().begin;
    return p.line != q.line ? p.line < q.line : p.column < q.column;
  });
  return keys;
}

Section::Section(const toml::table& table, std::string name, CaseSource& source,
                 std::vector<std::string> known)
    : table_(table), name_(std::move(name)), source_(source) {
  for (const toml::key* key : keys_in_file_order(table_)) {
    const std::string given(key->str());
    if (std::find(known.begin(), known.end(), given) != known.end()) continue;
    const std::string nearest = nearest_name(given, known);
    const std::string hint = nearest.empty() ? fmt::format("known are {}", fmt::join(known, ", "))
                                             : fmt::format("did you mean {}?", full_name(nearest));
    const bool section = name_.empty() && table_.get(given)->is_table();
    source_.refuse(key->source(), fmt::format("unknown {} {} ({})", section ? "section" : "key",
                                              full_name(given), hint));
  }
}

const toml::node* Section::find(const std::string& key) const { return table_.get(key); }

std::string Section::full_name(const std::string& key) const {
  return name_.empty() ? key : name_ + "." + key;
}

const toml::node& Section::require(const std::string& key, const std::string& required) const {
  const toml::node* node = find(key);
  if (!node) source_.refuse(place(), fmt::format("missing {} ({})", full_name(key), required));
  return *node;
}

double Section::number(const std::string& key, const NumberRule& rule) const {
  const std::string unit = *rule.unit ? fmt::format(" a number in {},", rule.unit) : "";
  return checked_number(require(key, "required:" + unit + " " + rule.required), full_name(key),
                        rule, source_);
}

double Section::number_or(const std::string& key, const NumberRule& rule, double fallback) const {
  return find(key) ? number(key, rule) : fallback;
}

int Section::integer(const std::string& key, int least, int largest) const {
  const std::string required = fmt::format("must be a whole number from {} to {}", least, largest);
  const toml::node& node = require(key, required);
  const auto* whole = node.as_integer();
  const auto* number = node.as_floating_point();
  // 4.0 is shown as it was written: "invalid nx = 4" would be a riddle
  const bool round = number && number->get() == std::trunc(number->get());
  if (!whole || whole->get() < least || whole->get() > largest)
    source_.refuse(node.source(), fmt::format("invalid {} = {}{} ({})", full_name(key), shown(node),
                                              round ? ".0" : "", required));
  return static_cast<int>(whole->get());
}

int Section::integer_or(const std::string& key, int least, int largest, int fallback) const {
  return find(key) ? integer(key, least, largest) : fallback;
}

bool Section::flag_or(const std::string& key, bool fallback) const {
  const toml::node* node = find(key);
  if (!node) return fallback;
  if (!node->is_boolean())
    source_.refuse(node->source(), fmt::format("invalid {} = {} (must be true or false)",
                                               full_name(key), shown(*node)));
  return node->as_boolean()->get();
}

std::string Section::text_or(const std::string& key, const std::string& fallback) const {
  const toml::node* node = find(key);
  if (!node) return fallback;
  if (!node->is_string())
    source_.refuse(node->source(), fmt::format("invalid {} = {} (must be a text in quotes)",
                                               full_name(key), shown(*node)));
  return node->as_string()->get();
}

NumberList Section::numbers(const std::string& key, const NumberRule& rule) const {
  const std::string required =
      fmt::format("must be a list of numbers{}{} or {{ from = …, to = …, count = … }}",
                  *rule.unit ? " in " : "", rule.unit);
  const toml::node& node = require(key, required);
  NumberList list;

  // Equidistant numbers
  if (node.is_table()) {
    const Section range = table(key, {"from", "to", "count"});
    const double from = range.number("from", rule), to = range.number("to", rule);
    const auto* count =
        range.require("count", fmt::format("must be a whole number from 2 to {}", kMostNumbers))
            .as_integer();
    if (count && count->get() > kMostNumbers)
      throw BudgetError(source_.place(count->source()) +
                        fmt::format("invalid {}.count = {} (must be at most {})", full_name(key),
                                    count->get(), kMostNumbers));
    const int steps = range.integer("count", 2, kMostNumbers) - 1;
    if (!(to > from))
      source_.refuse(range.find("to")->source(),
                     fmt::format("invalid {}.to = {} (must be greater than from)", full_name(key),
                                 with_unit(shown(*range.find("to")), rule)));
    for (int i = 0; i <= steps; ++i) list.value.push_back(from + (to - from) * i / steps);
    list.value.back() = to;
    list.place.assign(list.value.size(), node.source());
    return list;
  }

  // Listed numbers
  const toml::array* array = node.as_array();
  if (!array)
    source_.refuse(node.source(),
                   fmt::format("invalid {} = {} ({})", full_name(key), shown(node), required));
  if (array->empty())
    source_.refuse(node.source(),
                   fmt::format("invalid {} = [] (must not be empty)", full_name(key)));
  if (array->size() > kMostNumbers)
    throw BudgetError(source_.place(node.source()) +
                      fmt::format("invalid {} = a list of {} (must be at most {})", full_name(key),
                                  array->size(), kMostNumbers));
  for (const toml::node& element : *array) {
    list.value.push_back(checked_number(
        element, fmt::format("{}[{}]", full_name(key), list.value.size()), rule, source_));
    list.place.push_back(element.source());
  }
  return list;
}

Section Section::table(const std::string& key, std::vector<std::string> known) const {
  const toml::node& node = require(key, "required");
  if (!node.is_table())
    source_.refuse(node.source(),
                   fmt::format("invalid {} = {} (must be a {})", full_name(key), shown(node),
                               name_.empty() ? "section [" + key + "]" : "table { … }"));
  return Section(*node.as_table(), full_name(key), source_, std::move(known));
}

}  // namespace floe::io
