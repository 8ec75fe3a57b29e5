#include "io/case_sections.hpp"
#include "io/case_special_seas.hpp"
#include "io/case_spectra.hpp"

#include <floe/io/case_file.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace floe::io {
namespace {

constexpr NumberRule kFrequency{"rad/s", "must be 0.0001 to 1000",
                                [](double x) { return x >= 1e-4 && x <= 1e3; }};
std::vector<std::string> partition_keys() {
  std::vector<std::string> keys = spectrum_keys();
  keys.insert(keys.end(), spreading_keys().begin(), spreading_keys().end());
  keys.emplace_back("mean_heading_deg");
  return keys;
}

// Spectrum and spreading in words
std::string in_words(const Section& sea, const wave::Spectrum& spectrum) {
  return spectrum_words(sea, spectrum) + ", spreading " + spreading_words(sea);
}

void read_mean_headings(const Section& sea, wave::SeaState& state) {
  auto& all = state.mean_heading_deg;
  for (const double heading : sea.numbers("mean_heading_deg", heading_rule()).value)
    if (std::find(all.begin(), all.end(), heading) == all.end()) all.push_back(heading);
  warn_of_radians(sea, "mean_heading_deg", all);
}

// The tables under a key of a sea, which then has none of the keys `moved` itself
const toml::array& tables_of(const Section& sea, const std::string& key,
                             const std::vector<std::string>& moved) {
  for (const std::string& other : moved)
    if (sea.find(other))
      sea.source().refuse(
          sea.find(other)->source(),
          fmt::format("unused {} (a sea with {}s gives it in each)", sea.full_name(other), key));
  const toml::node& node = *sea.find(key);
  const toml::array* list = node.as_array();
  if (!list || list->empty() || !list->is_array_of_tables())
    sea.source().refuse(node.source(), fmt::format("invalid {} = {} (must be tables [[sea.{}]])",
                                                   sea.full_name(key), shown(node), key));
  return *list;
}

// Partitions of their own, each with its heading
void read_partitions(const Section& sea, wave::SeaState& state) {
  const toml::array& list = tables_of(sea, "partition", partition_keys());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Section partition(*list[i].as_table(), fmt::format("{}.partition[{}]", sea.name(), i),
                            sea.source(), partition_keys());
    const double heading = partition.number("mean_heading_deg", heading_rule());
    if (i == 0) state.mean_heading_deg = {heading};
    state.partitions.push_back({read_spectrum(partition), read_spreading(partition),
                                heading - state.mean_heading_deg.front()});
    state.description += (i == 0 ? "" : "; ") +
                         in_words(partition, state.partitions.back().spectrum) +
                         fmt::format(" to {}°", heading);
  }
}

wave::SeaState read_sea(const toml::table& table, std::size_t number,
                        const std::filesystem::path& folder, CaseSource& source) {
  std::vector<std::string> known = {"name", "partition", "zone", "duration", "allow_truncation"};
  for (const auto& keys : {partition_keys(), zone_keys(), measured_keys()})
    known.insert(known.end(), keys.begin(), keys.end());
  const Section sea(table, fmt::format("sea[{}]", number), source, known);
  wave::SeaState state;
  const toml::node& name = sea.require("name", "required: a name for the tables of results");
  state.name = sea.text_or("name", "");
  check_name(state.name, name.source(), sea.full_name("name"), source);
  const NumberRule duration{"s", "must be 60 to 1e9",
                            [](double x) { return x >= 60.0 && x <= 1e9; }};
  state.duration = sea.number_or("duration", duration, state.duration);
  state.allow_truncation = sea.flag_or("allow_truncation", false);

  // One of four kinds: measured, of zones, of partitions, or one spectrum everywhere
  const bool measured = sea.text_or("spectrum", "") == "measured";
  if (!measured) refuse_keys_without(sea, "spectrum = \"measured\"", measured_keys());
  if (!sea.find("zone")) refuse_keys_without(sea, "[[sea.zone]]", zone_keys());
  if (measured) {
    read_measured(sea, folder, state);
  } else if (sea.find("zone")) {
    read_zones(sea, tables_of(sea, "zone", spectrum_keys()), state);
    read_mean_headings(sea, state);
  } else if (sea.find("partition")) {
    read_partitions(sea, state);
  } else {
    state.partitions.push_back({read_spectrum(sea), read_spreading(sea)});
    state.description = in_words(sea, state.partitions.back().spectrum);
    read_mean_headings(sea, state);
  }
  return state;
}

void read_sea_grid(const Section& root, Case& data) {
  if (!root.find("sea_grid")) return;
  const Section grid = root.table("sea_grid", {"omega", "tolerance"});
  const NumberRule tolerance{"", "must be 1e-6 to 0.1",
                             [](double x) { return x >= 1e-6 && x <= 0.1; }};
  data.sea_grid.tolerance = grid.number_or("tolerance", tolerance, data.sea_grid.tolerance);
  if (!grid.find("omega")) return;
  const Section omega = grid.table("omega", {"from", "to"});
  if (omega.find("from")) data.sea_grid.from = omega.number("from", kFrequency);
  if (omega.find("to")) data.sea_grid.to = omega.number("to", kFrequency);
  if (data.sea_grid.from && data.sea_grid.to && !(*data.sea_grid.to > *data.sea_grid.from))
    omega.source().refuse(omega.find("to")->source(),
                          fmt::format("invalid {} = {} rad/s (must be greater than from)",
                                      omega.full_name("to"), *data.sea_grid.to));
}

}  // namespace

std::vector<wave::SeaState> read_sea_states(const Section& root,
                                            const std::filesystem::path& folder) {
  std::vector<wave::SeaState> seas;
  const toml::node* node = root.find("sea");
  if (!node) return seas;
  const toml::array* list = node->as_array();
  if (!list || !list->is_array_of_tables())
    root.source().refuse(node->source(),
                         fmt::format("invalid sea = {} (must be tables [[sea]])", shown(*node)));
  std::set<std::string> names;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const toml::table& table = *(*list)[i].as_table();
    try {
      seas.push_back(read_sea(table, i, folder, root.source()));
    } catch (const BudgetError&) {
      throw;
    } catch (const InputError& error) {
      throw DataError(error.what());
    }
    if (!names.insert(seas.back().name).second)
      throw DataError(root.source().place(table.get("name")->source()) +
                      fmt::format("invalid sea[{}].name = {} (must differ from the others)", i,
                                  shown_text(seas.back().name)));
  }
  return seas;
}

void read_seas(const Section& root, const std::filesystem::path& folder, Case& data) {
  read_sea_grid(root, data);
  data.seas = read_sea_states(root, folder);
  if (const toml::node* node = root.find("sea")) {
    std::ostringstream text;
    text << toml::json_formatter(*node);  // the other one computes widths beyond any type
    data.sea_text = text.str();
  }
  data.sea_files = root.source().files;
}

}  // namespace floe::io
