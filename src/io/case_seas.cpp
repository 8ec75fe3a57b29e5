#include "io/case_sections.hpp"

#include <floe/io/case_file.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace floe::io {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr NumberRule kFrequency{"rad/s", "must be 0.0001 to 1000",
                                [](double x) { return x >= 1e-4 && x <= 1e3; }};
constexpr NumberRule kHeight{"m", "must be positive", is_positive};
constexpr NumberRule kPeriod{"s", "must be 0.1 to 1000",
                             [](double x) { return x >= 0.1 && x <= 1e3; }};
constexpr NumberRule kGamma{"", "must be 1 to 20", [](double x) { return x >= 1.0 && x <= 20.0; }};
constexpr NumberRule kDensity{"m² s/rad", "must be at least 0",
                              [](double x) { return std::isfinite(x) && x >= 0.0; }};

const std::vector<std::string>& spectrum_names() {
  static const std::vector<std::string> names = {"bretschneider", "pierson-moskowitz", "jonswap",
                                                 "table"};
  return names;
}

const std::vector<std::string>& spreading_names() {
  static const std::vector<std::string> names = {"cos2", "cosn", "cos2s", "wrapped-normal", "none"};
  return names;
}

std::vector<std::string> partition_keys() {
  return {"spectrum",
          "significant_height",
          "significant_period",
          "peak_period",
          "gamma",
          "omega",
          "density",
          "spreading",
          "n",
          "s",
          "std_deg",
          "mean_heading_deg"};
}

// One of a few names; what is not given or unknown is refused with the nearest
std::string chosen_name(const Section& sea, const std::string& key,
                        const std::vector<std::string>& names) {
  const std::string required = fmt::format("must be one of {}", fmt::join(names, ", "));
  const toml::node& node = sea.require(key, "required: " + required);
  const std::string given = sea.text_or(key, "");
  if (std::find(names.begin(), names.end(), given) != names.end()) return given;
  const std::string nearest = nearest_name(given, names);
  sea.source().refuse(node.source(),
                      fmt::format("invalid {} = {} ({})", sea.full_name(key), shown(node),
                                  nearest.empty() ? required : "did you mean " + nearest + "?"));
}

// Keys that belong to another spectrum or spreading would be silently without effect
void refuse_keys_of_others(const Section& sea, const std::string& key, const std::string& chosen,
                           const std::vector<std::string>& all,
                           const std::vector<std::string>& used) {
  for (const std::string& other : all)
    if (sea.find(other) && std::find(used.begin(), used.end(), other) == used.end())
      sea.source().refuse(
          sea.find(other)->source(),
          fmt::format("unused {} (a {} = \"{}\" {})", sea.full_name(other), key, chosen,
                      used.empty() ? "takes no further key"
                                   : fmt::format("takes {}", fmt::join(used, ", "))));
}

wave::Spectrum read_table(const Section& sea) {
  const NumberList omega = sea.numbers("omega", kFrequency);
  const NumberList density = sea.numbers("density", kDensity);
  if (density.value.size() != omega.value.size() || omega.value.size() < 2)
    sea.source().refuse(
        sea.find("density")->source(),
        fmt::format("invalid {} = a list of {} (must be as long as omega, {}, and 2 or more)",
                    sea.full_name("density"), density.value.size(), omega.value.size()));
  for (std::size_t i = 1; i < omega.value.size(); ++i)
    if (!(omega.value[i] > omega.value[i - 1]))
      sea.source().refuse(omega.place[i],
                          fmt::format("invalid {}[{}] = {} rad/s (must be greater than the one "
                                      "before)",
                                      sea.full_name("omega"), i, omega.value[i]));
  if (std::all_of(density.value.begin(), density.value.end(), [](double x) { return x == 0.0; }))
    sea.source().refuse(
        sea.find("density")->source(),
        fmt::format("invalid {} = zeros (must hold energy)", sea.full_name("density")));
  return wave::Spectrum::tabulated(omega.value, density.value);
}

wave::Spectrum read_spectrum(const Section& sea) {
  const std::string kind = chosen_name(sea, "spectrum", spectrum_names());
  std::vector<std::string> used = {"significant_height", "peak_period"};
  if (kind == "bretschneider") used[1] = "significant_period";
  if (kind == "jonswap") used.emplace_back("gamma");
  if (kind == "table") used = {"omega", "density"};
  refuse_keys_of_others(
      sea, "spectrum", kind,
      {"significant_height", "significant_period", "peak_period", "gamma", "omega", "density"},
      used);
  if (kind == "table") return read_table(sea);
  const double height = sea.number("significant_height", kHeight);
  const double period = sea.number(used[1], kPeriod);
  if (kind == "bretschneider") return wave::Spectrum::bretschneider(height, period);
  if (kind == "pierson-moskowitz") return wave::Spectrum::pierson_moskowitz(height, period);
  return wave::Spectrum::jonswap(height, period, sea.number_or("gamma", kGamma, 3.3));
}

wave::Spreading read_spreading(const Section& sea) {
  const std::string kind = chosen_name(sea, "spreading", spreading_names());
  std::vector<std::string> used;
  if (kind == "cosn") used = {"n"};
  if (kind == "cos2s") used = {"s"};
  if (kind == "wrapped-normal") used = {"std_deg"};
  refuse_keys_of_others(sea, "spreading", kind, {"n", "s", "std_deg"}, used);
  if (kind == "cos2") return wave::Spreading::cosine_power(2.0);
  if (kind == "none") return wave::Spreading::none();
  if (kind == "cosn")
    return wave::Spreading::cosine_power(sea.number(
        "n", {"", "must be 1 to 1000", [](double x) { return x >= 1.0 && x <= 1000.0; }}));
  if (kind == "cos2s")
    return wave::Spreading::half_angle_cosine(sea.number(
        "s", {"", "must be 0.5 to 1000", [](double x) { return x >= 0.5 && x <= 1000.0; }}));
  const NumberRule deviation{"°", "must be 0.5 to 120",
                             [](double x) { return x >= 0.5 && x <= 120.0; }};
  return wave::Spreading::wrapped_normal(kDegree * sea.number("std_deg", deviation));
}

// Spectrum and spreading in words
std::string in_words(const Section& sea, const wave::Spectrum& spectrum) {
  std::string numbers;
  const auto add = [&](const std::string& what, const std::string& value) {
    numbers += (numbers.empty() ? "" : ", ") + what + " = " + value;
  };
  for (const char* key : {"significant_height", "significant_period", "peak_period", "gamma"})
    if (const toml::node* node = sea.find(key)) add(key, shown(*node));
  if (sea.find("omega"))
    add("4√m0", fmt::format("{:.6g} over {} frequencies", 4.0 * std::sqrt(spectrum.m0()),
                            sea.numbers("omega", kFrequency).value.size()));
  std::string spread = sea.text_or("spreading", "");
  for (const char* key : {"n", "s", "std_deg"})
    if (const toml::node* node = sea.find(key))
      spread += fmt::format(" {} = {}", key, shown(*node));
  return fmt::format("{} ({}), spreading {}", sea.text_or("spectrum", ""), numbers, spread);
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
  if (const toml::node* node = sea.find("allow_truncation")) {
    if (!node->is_boolean())
      source.refuse(node->source(), fmt::format("invalid {} = {} (must be true or false)",
                                                sea.full_name("allow_truncation"), shown(*node)));
    state.allow_truncation = node->as_boolean()->get();
  }
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
