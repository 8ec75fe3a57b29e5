#define XXH_INLINE_ALL
#include "io/measured_spectrum.hpp"
#include "io/toml_section.hpp"

#include <floe/numeric/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

/// From a spectrum as a file holds it to the frame and the units of floe.
namespace floe::io {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-6;  // of the largest density: less below 0 is none

// "m^{2}.s.degree^{-1}" and "m2 s degree-1" are one unit
std::string plain_unit(const std::string& text) {
  std::string plain;
  for (const char c : text)
    if (std::string_view(" .*^{}()_").find(c) == std::string_view::npos)
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* name : {"degrees", "degree", "radians", "radian"})
    if (const auto at = plain.find(name); at != std::string::npos)
      plain.replace(at, std::string_view(name).size(), name[0] == 'd' ? "deg" : "rad");
  return plain;
}

struct Unit {
  const char* name;  // as a sea's keys have it
  std::vector<std::string> spellings;
  double factor;  // to SI units per rad/s and rad
};

const std::vector<Unit>& directional_units() {
  static const std::vector<Unit> units = {
      {"m2 s degree-1",
       {"m2sdeg-1", "m2s/deg", "m2/hz/deg", "m2hz-1deg-1", "m2deg-1s", "m2/(hzdeg)"},
       0.5 / kPi * 180.0 / kPi},
      {"m2 s rad-1", {"m2srad-1", "m2s/rad", "m2/hz/rad", "m2hz-1rad-1", "m2rad-1s"}, 0.5 / kPi}};
  return units;
}

const std::vector<Unit>& summed_units() {
  static const std::vector<Unit> units = {{"m2 s", {"m2s", "m2/hz", "m2hz-1"}, 0.5 / kPi}};
  return units;
}

const std::vector<Unit>& frequency_units() {
  static const std::vector<Unit> units = {{"Hz", {"hz", "s-1", "1/s"}, 2.0 * kPi}};
  return units;
}

const std::vector<Unit>& direction_units() {
  static const std::vector<Unit> units = {{"degree", {"deg", "degt", "degtrue"}, kPi / 180.0},
                                          {"rad", {"rad"}, 1.0}};
  return units;
}

const Unit* find_unit(const std::vector<Unit>& units, const std::string& text) {
  const std::string plain = plain_unit(text);
  for (const Unit& unit : units)
    if (plain == plain_unit(unit.name) ||
        std::find(unit.spellings.begin(), unit.spellings.end(), plain) != unit.spellings.end())
      return &unit;
  return nullptr;
}

// The unit that the file or the user says; both must not contradict each other
const Unit& unit_of(const char* what, const std::string& in_file, const std::string& given,
                    const char* key, const std::vector<Unit>& units) {
  std::vector<std::string> names;
  for (const Unit& unit : units) names.push_back(fmt::format("\"{}\"", unit.name));
  const std::string choice = fmt::format("{}", fmt::join(names, " or "));
  if (in_file.empty() && given.empty())
    throw DataError(
        fmt::format("the file does not say the units of {} (give {} = {})", what, key, choice));
  const Unit* own = in_file.empty() ? nullptr : find_unit(units, in_file);
  const Unit* asked = given.empty() ? nullptr : find_unit(units, given);
  if (!in_file.empty() && !own)
    throw DataError(fmt::format("unknown units {} of {} in the file (must be {})",
                                shown_text(in_file), what, choice));
  if (!given.empty() && !asked)
    throw DataError(fmt::format("invalid {} = {} (must be {})", key, shown_text(given), choice));
  if (own && asked && own != asked)
    throw DataError(fmt::format("{} = {}, but the file has {} in {}", key, shown_text(given), what,
                                shown_text(in_file)));
  return own ? *own : *asked;
}

bool comes_from(const StoredSpectrum& stored, const MeasuredRequest& request) {
  const auto says = [&](const char* word) {
    return stored.direction_name.find(std::string(word) + "_direction") != std::string::npos ||
           stored.direction_name.find(std::string(word) + " direction") != std::string::npos;
  };
  const bool from = says("from"), to = says("to");
  const std::string own = from == to ? "" : (from ? "coming-from" : "going-to");
  if (own.empty() && request.directions.empty())
    throw DataError(
        "the file does not say whether waves come from its directions or go to them "
        "(give directions = \"coming-from\" or \"going-to\")");
  if (!own.empty() && !request.directions.empty() && own != request.directions)
    throw DataError(fmt::format("directions = \"{}\", but the file says {}", request.directions,
                                shown_text(stored.direction_name)));
  return (own.empty() ? request.directions : own) == "coming-from";
}

// Missing and negative values; those of rounding become 0
void clean(StoredSpectrum& stored, MeasuredSea& sea) {
  std::size_t missing = 0, below = 0;
  double largest = 0.0, lowest = 0.0;
  for (const double value : stored.density) {
    if (!(std::abs(value) < 1e30))
      ++missing;  // NaN, and what a file is filled with
    else
      largest = std::max(largest, value);
  }
  if (missing > 0)
    throw DataError(fmt::format("{} of the {} values of efth are missing or not finite", missing,
                                stored.density.size()));
  for (double& value : stored.density) {
    if (!(value < 0.0)) continue;
    ++below;
    lowest = std::min(lowest, value);
    value = 0.0;
  }
  if (lowest < -kRounding * largest)
    throw DataError(
        fmt::format("{} values of efth are negative, down to {:.3g} (must be at least "
                    "0; rounding, {:g} of the largest, is passed over)",
                    below, lowest, kRounding));
  if (!(largest > 0.0)) throw DataError("the spectrum holds no energy: all values of efth are 0");
  if (below > 0)
    sea.notices.push_back(fmt::format(
        "{} values of efth below 0 by rounding, down to {:.2g}, became 0", below, lowest));
}

// The order that sorts values; a notice where they were not sorted
std::vector<Index> sorted(const std::vector<double>& values, const char* what, bool was_sorted,
                          MeasuredSea& sea) {
  std::vector<Index> order(values.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return values[static_cast<std::size_t>(a)] < values[static_cast<std::size_t>(b)];
  });
  if (!was_sorted) sea.notices.push_back(fmt::format("the {} were sorted", what));
  return order;
}

void require_finite(const std::vector<double>& values, const char* what) {
  for (const double value : values)
    if (!(std::abs(value) < 1e6))
      throw DataError(fmt::format("a value of {} is missing or not finite", what));
}

// Frequencies [rad/s] by rising value, rows of the density with them
std::vector<double> take_frequencies(const StoredSpectrum& stored, double factor, MatXd& density,
                                     MeasuredSea& sea) {
  require_finite(stored.frequency, "the frequencies");
  const bool rising = std::is_sorted(stored.frequency.begin(), stored.frequency.end());
  const std::vector<Index> order = sorted(stored.frequency, "frequencies", rising, sea);
  std::vector<double> omega;
  for (const Index i : order) {
    const double frequency = stored.frequency[static_cast<std::size_t>(i)];
    if (frequency < 0.0 || (!omega.empty() && factor * frequency == omega.back()))
      throw DataError(fmt::format("the frequency {} Hz is {} (must be at least 0, each once)",
                                  frequency, frequency < 0.0 ? "negative" : "given twice"));
    omega.push_back(factor * frequency);
  }
  if (omega.size() < 2)
    throw DataError(fmt::format("{} frequencies (must be 2 or more)", omega.size()));
  density = MatXd(density(order, Eigen::all));
  return omega;
}

// One of two equal directions goes; different ones contradict each other
void drop_doubles(std::vector<double>& heading, MatXd& density, MeasuredSea& sea) {
  const double turn = 2.0 * kPi, largest = density.maxCoeff();
  std::vector<Index> kept;
  for (std::size_t j = 0; j < heading.size(); ++j) {
    const std::size_t next = (j + 1) % heading.size();
    const double gap = heading[next] - heading[j] + (next == 0 ? turn : 0.0);
    const auto column = static_cast<Index>(j), other = static_cast<Index>(next);
    if (gap > 1e-6 || heading.size() == 1) {
      kept.push_back(column);
    } else if ((density.col(column) - density.col(other)).cwiseAbs().maxCoeff() >
               kRounding * largest) {
      throw DataError("a direction is given twice with different values");
    }
  }
  if (kept.size() == heading.size()) return;
  sea.notices.push_back(fmt::format("{} directions that were given twice were dropped",
                                    heading.size() - kept.size()));
  std::vector<double> once;
  for (const Index j : kept) once.push_back(heading[static_cast<std::size_t>(j)]);
  heading = std::move(once);
  density = MatXd(density(Eigen::all, kept));
}

// The circle must be closed: one gap twice as wide as all others is a sector that was left out
void require_circle(const std::vector<double>& heading) {
  if (heading.size() < 3)
    throw DataError(fmt::format("{} directions (must be 3 or more)", heading.size()));
  std::vector<double> gaps = {heading.front() + 2.0 * kPi - heading.back()};
  for (std::size_t j = 1; j < heading.size(); ++j) gaps.push_back(heading[j] - heading[j - 1]);
  std::sort(gaps.begin(), gaps.end());
  if (gaps.back() > 2.0 * gaps[gaps.size() - 2])
    throw DataError(fmt::format("the directions leave out {:.3g}° (must go round the circle)",
                                gaps.back() * 180.0 / kPi));
}

// Headings [rad] from 0 to 2π by rising value, columns of the density with them (E.26)
std::vector<double> take_directions(const StoredSpectrum& stored, const MeasuredRequest& request,
                                    MatXd& density, MeasuredSea& sea) {
  require_finite(stored.direction, "the directions");
  const double factor = unit_of("the directions", stored.direction_units, request.direction_units,
                                "direction_units", direction_units())
                            .factor;
  const bool from = comes_from(stored, request);
  if (!request.x_axis_bearing_deg)
    throw DataError(
        "missing x_axis_bearing_deg (required: degrees from north, clockwise, of the "
        "structure's +x)");
  const double bearing = *request.x_axis_bearing_deg * kPi / 180.0;
  std::vector<double> heading;
  for (const double direction : stored.direction) {
    const double value =
        std::remainder(bearing - factor * direction - (from ? kPi : 0.0), 2.0 * kPi);
    heading.push_back(value < 0.0 ? value + 2.0 * kPi : value);
  }
  const auto& given = stored.direction;
  const auto turns = std::is_sorted_until(given.begin(), given.end());
  const bool rising =
      turns == given.end() || (std::is_sorted(turns, given.end()) && given.back() <= given.front());
  const std::vector<Index> order = sorted(heading, "directions", rising, sea);
  std::vector<double> ordered;
  for (const Index j : order) ordered.push_back(heading[static_cast<std::size_t>(j)]);
  density = MatXd(density(Eigen::all, order));
  drop_doubles(ordered, density, sea);
  require_circle(ordered);
  return ordered;
}

void describe(const StoredSpectrum& stored, const MeasuredRequest& request, MeasuredSea& sea) {
  // Two files of the same height are two seas
  const XXH64_hash_t content =
      XXH3_64bits(stored.density.data(), stored.density.size() * sizeof(double));
  sea.description = fmt::format(
      "measured (time {}, site {}, {} frequencies, {} directions, 4√m0 = {:.4g}, content {:016x})",
      request.time_index.value_or(0), request.site_index.value_or(0), stored.frequency.size(),
      stored.direction.size(), 4.0 * std::sqrt(sea.spectrum->m0()), content);
  if (sea.directional)
    sea.description += fmt::format(", x axis to {}°", *request.x_axis_bearing_deg);
}

}  // namespace

MeasuredSea measured_sea(StoredSpectrum stored, const MeasuredRequest& request) {
  MeasuredSea sea;
  clean(stored, sea);
  const bool directional = !stored.direction.empty();
  const double unit = unit_of("efth", stored.density_units, request.density_units, "density_units",
                              directional ? directional_units() : summed_units())
                          .factor;
  const double hertz = unit_of("the frequencies", stored.frequency_units, request.frequency_units,
                               "frequency_units", frequency_units())
                           .factor;
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto rows = static_cast<Index>(stored.frequency.size());
  MatXd density = unit * Eigen::Map<const RowMajor>(
                             stored.density.data(), rows,
                             static_cast<Index>(stored.density.size()) / std::max<Index>(rows, 1));
  const std::vector<double> omega = take_frequencies(stored, hertz, density, sea);
  if (directional) {
    std::vector<double> heading = take_directions(stored, request, density, sea);
    sea.directional.emplace(omega, std::move(heading), std::move(density));
    sea.spectrum = sea.directional->over_directions();
  } else {
    sea.spectrum = wave::Spectrum::tabulated(omega, {density.data(), density.data() + rows});
  }
  describe(stored, request, sea);
  return sea;
}

}  // namespace floe::io
