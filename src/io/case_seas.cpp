#include "io/case_sections.hpp"
#include "io/case_spectra.hpp"

#include <floe/io/case_file.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

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

// Partitions of their own, each with its heading, or the one that the sea itself describes
void read_partitions(const Section& sea, wave::SeaState& state) {
  const toml::node* node = sea.find("partition");
  if (!node) {
    state.partitions.push_back({read_spectrum(sea), read_spreading(sea)});
    state.description = in_words(sea, state.partitions.back().spectrum);
    const NumberList headings = sea.numbers("mean_heading_deg", heading_rule());
    for (const double heading : headings.value) {
      auto& all = state.mean_heading_deg;
      if (std::find(all.begin(), all.end(), heading) == all.end()) all.push_back(heading);
    }
    return;
  }
  for (const std::string& key : partition_keys())
    if (sea.find(key))
      sea.source().refuse(
          sea.find(key)->source(),
          fmt::format("unused {} (a sea with partitions gives it in each)", sea.full_name(key)));
  const toml::array* list = node->as_array();
  if (!list || list->empty() || !list->is_array_of_tables())
    sea.source().refuse(node->source(),
                        fmt::format("invalid {} = {} (must be tables [[sea.partition]])",
                                    sea.full_name("partition"), shown(*node)));
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Section partition(*(*list)[i].as_table(), fmt::format("{}.partition[{}]", sea.name(), i),
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

wave::SeaState read_sea(const toml::table& table, std::size_t number, CaseSource& source) {
  std::vector<std::string> known = {"name", "partition", "duration", "allow_truncation"};
  for (const std::string& key : partition_keys()) known.push_back(key);
  const Section sea(table, fmt::format("sea[{}]", number), source, known);
  wave::SeaState state;
  const toml::node& name = sea.require("name", "required: a name for the tables of results");
  state.name = sea.text_or("name", "");
  check_name(state.name, name.source(), sea.full_name("name"), source);
  const NumberRule duration{"s", "must be 60 to 1e9",
                            [](double x) { return x >= 60.0 && x <= 1e9; }};
  state.duration = sea.number_or("duration", duration, state.duration);
  state.allow_truncation = sea.flag_or("allow_truncation", false);
  read_partitions(sea, state);
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

std::vector<wave::SeaState> read_sea_states(const Section& root) {
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
      seas.push_back(read_sea(table, i, root.source()));
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

void read_seas(const Section& root, Case& data) {
  read_sea_grid(root, data);
  data.seas = read_sea_states(root);
}

}  // namespace floe::io
