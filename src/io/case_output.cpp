#include "io/case_sections.hpp"

#include <floe/io/case_file.hpp>
#include <floe/response/modal_basis.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace floe::io {
namespace {

constexpr std::size_t kLongestName = 64;
constexpr const char* kNameRequired =
    "must be 1 to 64 characters without blanks, commas, quotes and control characters, not "
    "beginning with = + - @ #";

// Names go into CSV cells unquoted and into spreadsheets: nothing there may be special
bool is_good_name(std::string_view name) {
  if (name.empty() || name.size() > kLongestName) return false;
  if (std::string_view("=+-@#").find(name[0]) != std::string_view::npos) return false;
  return std::none_of(name.begin(), name.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte <= 0x20 || byte == 0x7f ||
           std::string_view(",;\"'`").find(c) != std::string_view::npos;
  });
}

std::vector<NamedPoint> read_points(const Section& output, const std::string& key) {
  std::vector<NamedPoint> points;
  const toml::table& table = named_table(output, key);
  for (const toml::key* name : keys_in_file_order(table)) {
    const std::string full = output.full_name(key) + "." + std::string(name->str());
    const auto [x, y] = checked_point(*table.get(name->str()), full, output.source());
    points.push_back({std::string(name->str()), Point2(x, y),
                      output.source().place(table.get(name->str())->source())});
  }
  return points;
}

std::vector<NamedLine> read_lines(const Section& output) {
  constexpr int kMostStations = 1'000'000;
  std::vector<NamedLine> lines;
  const toml::table& table = named_table(output, "lines");
  std::vector<std::string> names;
  for (const toml::key* name : keys_in_file_order(table)) names.emplace_back(name->str());
  const Section all(table, output.full_name("lines"), output.source(), names);
  for (const std::string& name : names) {
    const Section line = all.table(name, {"from", "to", "count"});
    const char* required = "must be two numbers [x, y] in m";
    const auto from =
        checked_point(line.require("from", required), line.full_name("from"), line.source());
    const auto to =
        checked_point(line.require("to", required), line.full_name("to"), line.source());
    lines.push_back({name, Point2(from.first, from.second), Point2(to.first, to.second),
                     line.integer("count", 2, kMostStations), line.source().place(line.place())});
    if (lines.back().from == lines.back().to)
      line.source().refuse(
          line.find("to")->source(),
          fmt::format("invalid {} = [{}, {}] (must differ from {})", line.full_name("to"), to.first,
                      to.second, line.full_name("from")));
  }
  return lines;
}

std::vector<response::Quantity> read_quantities(const Section& output) {
  std::vector<response::Quantity> quantities;
  std::vector<std::string> known;
  for (const response::Quantity quantity : response::all_quantities())
    known.emplace_back(response::name(quantity));
  const toml::node& node = *output.find("quantities");
  const std::string full = output.full_name("quantities");
  const toml::array* array = node.as_array();
  if (!array)
    output.source().refuse(
        node.source(), fmt::format("invalid {} = {} (must be a list of names)", full, shown(node)));
  for (std::size_t i = 0; i < array->size(); ++i) {
    const toml::node& element = (*array)[i];
    const auto* text = element.as_string();
    const auto quantity = text ? response::quantity_from_name(text->get()) : std::nullopt;
    if (!quantity) {
      const std::string nearest = text ? nearest_name(text->get(), known) : "";
      const std::string hint = nearest.empty()
                                   ? fmt::format("must be one of {}", fmt::join(known, ", "))
                                   : fmt::format("did you mean {}?", nearest);
      output.source().refuse(
          element.source(), fmt::format("invalid {}[{}] = {} ({})", full, i, shown(element), hint));
    }
    if (std::find(quantities.begin(), quantities.end(), *quantity) == quantities.end())
      quantities.push_back(*quantity);
    else
      output.source().notices.push_back(
          fmt::format("{}: {} given twice, once dropped", full, shown(element)));
  }
  return quantities;
}

// Nothing is known of the inside of a structure that another program has made
void refuse_section_forces(const Section& output,
                           const std::vector<response::Quantity>& quantities) {
  for (const response::Quantity quantity : quantities)
    if (response::is_section_force(quantity))
      output.source().refuse(
          output.find("quantities")->source(),
          fmt::format("invalid {} = {} (must follow from deflections or pressures: plate.structure "
                      "tells nothing of forces and stresses within the plate)",
                      output.full_name("quantities"), response::name(quantity)));
}

// The value of `list` that `value` means, to rounding of a converted number
double matched(const std::vector<double>& list, double value, double tolerance,
               const toml::node& node, const std::string& name, const char* where,
               const CaseSource& source) {
  const auto nearest = std::min_element(list.begin(), list.end(), [&](double a, double b) {
    return std::abs(a - value) < std::abs(b - value);
  });
  if (std::abs(*nearest - value) > tolerance)
    source.refuse(node.source(),
                  fmt::format("invalid {} = {} (must be one of {})", name, shown(node), where));
  return *nearest;
}

std::vector<FieldRequest> read_fields(const Section& output, const Case& data) {
  const toml::node& node = *output.find("fields");
  const toml::array* array = node.as_array();
  if (!array)
    output.source().refuse(
        node.source(),
        fmt::format("invalid {} = {} (must be a list of {{ omega = …, heading_deg = … }})",
                    output.full_name("fields"), shown(node)));
  std::vector<FieldRequest> fields;
  for (const toml::node& element : *array) {
    const std::string name = fmt::format("{}[{}]", output.full_name("fields"), fields.size());
    if (!element.is_table())
      output.source().refuse(
          element.source(),
          fmt::format("invalid {} = {} (must be a table {{ omega = …, heading_deg = … }})", name,
                      shown(element)));
    const Section field(*element.as_table(), name, output.source(), {"omega", "heading_deg"});
    const double omega = field.number("omega", axis_rule("omega"));
    const double heading = field.number("heading_deg", heading_rule());
    fields.push_back(
        {.omega = matched(data.omega, omega, 1e-6 * omega, *field.find("omega"),
                          field.full_name("omega"), "the frequencies of [waves]", output.source()),
         .heading_deg =
             matched(data.heading_deg, heading, 1e-9, *field.find("heading_deg"),
                     field.full_name("heading_deg"), "waves.heading_deg", output.source())});
  }
  return fields;
}

}  // namespace

void check_name(std::string_view name, const toml::source_region& place, const std::string& what,
                const CaseSource& source) {
  if (!is_good_name(name))
    source.refuse(place,
                  fmt::format("invalid {} = {} ({})", what, shown_text(name), kNameRequired));
}

const toml::table& named_table(const Section& section, const std::string& key) {
  static const toml::table none;
  const toml::node* node = section.find(key);
  if (!node) return none;
  if (!node->is_table())
    section.source().refuse(node->source(),
                            fmt::format("invalid {} = {} (must be a table {{ name = … }})",
                                        section.full_name(key), shown(*node)));
  for (const toml::key* name : keys_in_file_order(*node->as_table()))
    check_name(name->str(), name->source(), "name in " + section.full_name(key), section.source());
  return *node->as_table();
}

void read_output(const Section& root, Case& data) {
  if (!root.find("output")) return;
  const Section output =
      root.table("output", {"points", "lines", "wave_points", "quantities", "cross_spectra",
                            "combinations", "node_spectra", "fields"});
  data.points = read_points(output, "points");
  data.lines = read_lines(output);
  data.wave_points = read_points(output, "wave_points");
  if (output.find("quantities")) data.quantities = read_quantities(output);
  if (data.structure) refuse_section_forces(output, data.quantities);
  read_relations(output, data);
  if (output.find("fields")) data.fields = read_fields(output, data);
}

}  // namespace floe::io
