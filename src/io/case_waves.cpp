#include "io/case_sections.hpp"

#include <floe/numeric/error.hpp>
#include <floe/wave/dispersion.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::io {
namespace {

constexpr double kLowestFrequency = 1e-4;  // [rad/s]
constexpr double kHighestFrequency = 1e3;  // [rad/s]

// The one key that says which waves
std::string chosen_axis(const Section& waves) {
  std::vector<std::string> given;
  for (const std::string& axis : wave_axes())
    if (waves.find(axis)) given.push_back(axis);
  const std::string choice = fmt::format("{}", fmt::join(wave_axes(), ", "));
  if (given.empty())
    waves.source().refuse(waves.place(),
                          fmt::format("missing waves (must hold one of {})", choice));
  if (given.size() > 1)
    waves.source().refuse(
        waves.find(given[1])->source(),
        fmt::format("ambiguous waves.{} beside waves.{} (must be exactly one of {})", given[1],
                    given[0], choice));
  return given[0];
}

void read_frequencies(const Section& waves, Case& data) {
  const std::string axis = chosen_axis(waves);
  const NumberList list = waves.numbers(axis, axis_rule(axis));

  // Turn them into frequencies
  std::vector<double> omega;
  for (std::size_t i = 0; i < list.value.size(); ++i) {
    omega.push_back(axis_frequency(axis, list.value[i], data.water));
    if (!(omega[i] >= kLowestFrequency && omega[i] <= kHighestFrequency))
      waves.source().refuse(
          list.place[i],
          fmt::format("invalid waves.{} = {} {} (must mean a frequency of {} to {} rad/s)", axis,
                      list.value[i], axis_rule(axis).unit, kLowestFrequency, kHighestFrequency));
  }

  // Sort them and drop duplicates; an axis that runs the other way is no disorder
  const bool ordered =
      std::is_sorted(omega.begin(), omega.end()) ||
      (axis_frequency(axis, 2.0, data.water) < axis_frequency(axis, 1.0, data.water) &&
       std::is_sorted(omega.rbegin(), omega.rend()));
  std::sort(omega.begin(), omega.end());
  const auto last = std::unique(omega.begin(), omega.end());
  const auto duplicates = omega.end() - last;
  omega.erase(last, omega.end());
  if (!ordered) waves.source().notices.push_back(fmt::format("waves.{} sorted", axis));
  if (duplicates > 0)
    waves.source().notices.push_back(
        fmt::format("waves.{}: {} given twice dropped", axis, duplicates));
  data.omega = std::move(omega);
}

// Values like 0.7854 under a key in degrees are usually radians
bool look_like_radians(const std::vector<double>& headings) {
  bool any = false, fractional = false;
  for (const double heading : headings) {
    if (std::abs(heading) > 2.0 * std::numbers::pi) return false;
    any = any || heading != 0.0;
    fractional = fractional || heading != std::round(heading);
  }
  return any && fractional;
}

void read_headings(const Section& waves, Case& data) {
  const NumberList list = waves.numbers("heading_deg", heading_rule());
  for (const double heading : list.value) {
    const auto same = [&](double other) { return std::remainder(heading - other, 360.0) == 0.0; };
    if (std::none_of(data.heading_deg.begin(), data.heading_deg.end(), same))
      data.heading_deg.push_back(heading);
  }
  const std::size_t duplicates = list.value.size() - data.heading_deg.size();
  if (duplicates > 0)
    waves.source().notices.push_back(
        fmt::format("waves.heading_deg: {} given twice dropped", duplicates));
  warn_of_radians(waves, "heading_deg", data.heading_deg);
}

}  // namespace

const std::vector<std::string>& wave_axes() {
  static const std::vector<std::string> axes = {"omega", "period", "freq", "wavenumber",
                                                "wavelength"};
  return axes;
}

NumberRule axis_rule(const std::string& axis) {
  const char* unit = axis == "omega"        ? "rad/s"
                     : axis == "period"     ? "s"
                     : axis == "freq"       ? "Hz"
                     : axis == "wavenumber" ? "rad/m"
                                            : "m";
  return {unit, "must be positive", is_positive};
}

double axis_frequency(const std::string& axis, double value, const wave::Water& water) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  if (axis == "period") return kTurn / value;
  if (axis == "freq") return kTurn * value;
  if (axis == "wavenumber") return wave::angular_frequency(value, water);
  if (axis == "wavelength") return wave::angular_frequency(kTurn / value, water);
  return value;
}

NumberRule heading_rule() {
  return {"°", "must be -360 to 360", [](double x) { return x >= -360.0 && x <= 360.0; }};
}

void warn_of_radians(const Section& section, const std::string& key,
                     const std::vector<double>& degrees) {
  if (look_like_radians(degrees))
    section.source().warnings.push_back(
        fmt::format("{} = [{}] look like radians (did you mean degrees?)", section.full_name(key),
                    fmt::join(degrees, ", ")));
}

void read_waves(const Section& root, Case& data) {
  std::vector<std::string> known = wave_axes();
  known.emplace_back("heading_deg");
  const Section waves = root.table("waves", known);
  read_frequencies(waves, data);
  read_headings(waves, data);
}

}  // namespace floe::io
