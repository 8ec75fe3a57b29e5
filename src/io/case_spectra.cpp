#include "io/case_spectra.hpp"

#include "io/case_sections.hpp"

#include <floe/io/case_file.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::io {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr NumberRule kFrequency{"rad/s", "must be 0.0001 to 1000",
                                [](double x) { return x >= 1e-4 && x <= 1e3; }};
constexpr NumberRule kHeight{"m", "must be positive", is_positive};
constexpr NumberRule kPeriod{"s", "must be 0.1 to 1000",
                             [](double x) { return x >= 0.1 && x <= 1e3; }};
constexpr NumberRule kDensity{"m² s/rad", "must be at least 0",
                              [](double x) { return std::isfinite(x) && x >= 0.0; }};

const std::vector<std::string>& spectrum_names() {
  static const std::vector<std::string> names = {"bretschneider", "pierson-moskowitz", "jonswap",
                                                 "table", "measured"};
  return names;
}

const std::vector<std::string>& spreading_names() {
  static const std::vector<std::string> names = {"cos2", "cosn", "cos2s", "wrapped-normal", "none"};
  return names;
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

}  // namespace

const std::vector<std::string>& spectrum_keys() {
  static const std::vector<std::string> keys = {
      "spectrum", "significant_height", "significant_period", "peak_period", "gamma", "omega",
      "density"};
  return keys;
}

const std::vector<std::string>& spreading_keys() {
  static const std::vector<std::string> keys = {"spreading", "n", "s", "std_deg"};
  return keys;
}

NumberRule gamma_rule() {
  return {"", "must be 1 to 20", [](double x) { return x >= 1.0 && x <= 20.0; }};
}

std::string chosen_name(const Section& section, const std::string& key,
                        const std::vector<std::string>& names) {
  const std::string required = fmt::format("must be one of {}", fmt::join(names, ", "));
  const toml::node& node = section.require(key, "required: " + required);
  const std::string given = section.text_or(key, "");
  if (std::find(names.begin(), names.end(), given) != names.end()) return given;
  const std::string nearest = nearest_name(given, names);
  section.source().refuse(
      node.source(), fmt::format("invalid {} = {} ({})", section.full_name(key), shown(node),
                                 nearest.empty() ? required : "did you mean " + nearest + "?"));
}

void refuse_keys_of_others(const Section& section, const std::string& key,
                           const std::string& chosen, const std::vector<std::string>& all,
                           const std::vector<std::string>& used) {
  for (const std::string& other : all)
    if (section.find(other) && std::find(used.begin(), used.end(), other) == used.end())
      section.source().refuse(
          section.find(other)->source(),
          fmt::format("unused {} (a {} = \"{}\" {})", section.full_name(other), key, chosen,
                      used.empty() ? "takes no further key"
                                   : fmt::format("takes {}", fmt::join(used, ", "))));
}

wave::Spectrum read_spectrum(const Section& sea) {
  const std::string kind = chosen_name(sea, "spectrum", spectrum_names());
  if (kind == "measured")
    sea.source().refuse(sea.find("spectrum")->source(),
                        fmt::format("invalid {} = \"measured\" (must be of a whole [[sea]])",
                                    sea.full_name("spectrum")));
  std::vector<std::string> used = {"significant_height", "peak_period"};
  if (kind == "bretschneider") used[1] = "significant_period";
  if (kind == "jonswap") used.emplace_back("gamma");
  if (kind == "table") used = {"omega", "density"};
  std::vector<std::string> all = spectrum_keys();
  all.erase(all.begin());  // the kind itself
  refuse_keys_of_others(sea, "spectrum", kind, all, used);
  if (kind == "table") return read_table(sea);
  const double height = sea.number("significant_height", kHeight);
  const double period = sea.number(used[1], kPeriod);
  if (kind == "bretschneider") return wave::Spectrum::bretschneider(height, period);
  if (kind == "pierson-moskowitz") return wave::Spectrum::pierson_moskowitz(height, period);
  return wave::Spectrum::jonswap(height, period, sea.number_or("gamma", gamma_rule(), 3.3));
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

std::string spectrum_words(const Section& sea, const wave::Spectrum& spectrum) {
  std::string numbers;
  const auto add = [&](const std::string& what, const std::string& value) {
    numbers += (numbers.empty() ? "" : ", ") + what + " = " + value;
  };
  const std::pair<const char*, const char*> units[] = {{"significant_height", " m"},
                                                       {"significant_period", " s"},
                                                       {"peak_period", " s"},
                                                       {"gamma", ""}};
  for (const auto& [key, unit] : units)
    if (const toml::node* node = sea.find(key)) add(key, shown(*node) + unit);
  if (sea.find("omega"))
    add("4√m0", fmt::format("{:.6g} m over {} frequencies", 4.0 * std::sqrt(spectrum.m0()),
                            sea.numbers("omega", kFrequency).value.size()));
  return fmt::format("{} ({})", sea.text_or("spectrum", ""), numbers);
}

std::string spreading_words(const Section& sea) {
  std::string words = sea.text_or("spreading", "");
  for (const char* key : {"n", "s", "std_deg"})
    if (const toml::node* node = sea.find(key)) words += fmt::format(" {} = {}", key, shown(*node));
  return words;
}

}  // namespace floe::io
