#include "io/case_special_seas.hpp"

#include "io/case_sections.hpp"
#include "io/case_spectra.hpp"
#include "io/measured_spectrum.hpp"

#include <floe/numeric/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe::io {
namespace {

constexpr int kMostIndex = 1'000'000'000;
constexpr NumberRule kBearing{"°", "must be -360 to 360",
                              [](double x) { return x >= -360.0 && x <= 360.0; }};
constexpr NumberRule kCoherence{"", "must be 0 to 1",
                                [](double x) { return x >= 0.0 && x <= 1.0; }};
constexpr NumberRule kPlace{"m", "must be finite", [](double x) { return std::isfinite(x); }};

std::optional<std::size_t> index_or_none(const Section& sea, const std::string& key) {
  if (!sea.find(key)) return std::nullopt;
  return static_cast<std::size_t>(sea.integer(key, 0, kMostIndex));
}

MeasuredRequest read_request(const Section& sea) {
  MeasuredRequest request;
  request.time_index = index_or_none(sea, "time_index");
  request.site_index = index_or_none(sea, "site_index");
  request.density_units = sea.text_or("density_units", "");
  request.frequency_units = sea.text_or("frequency_units", "");
  request.direction_units = sea.text_or("direction_units", "");
  if (sea.find("directions"))
    request.directions = chosen_name(sea, "directions", {"coming-from", "going-to"});
  if (sea.find("x_axis_bearing_deg"))
    request.x_axis_bearing_deg = sea.number("x_axis_bearing_deg", kBearing);
  return request;
}

// [from, to] under a key of a zone; without it the zone has no end that way
void read_extent(const Section& zone, const std::string& key, double& from, double& to) {
  const toml::node* node = zone.find(key);
  if (!node) return;
  const toml::array* pair = node->as_array();
  if (!pair || pair->size() != 2)
    zone.source().refuse(node->source(), fmt::format("invalid {} = {} (must be [from, to] in m)",
                                                     zone.full_name(key), shown(*node)));
  from = checked_number((*pair)[0], zone.full_name(key) + "[0]", kPlace, zone.source());
  to = checked_number((*pair)[1], zone.full_name(key) + "[1]", kPlace, zone.source());
  if (!(to > from))
    zone.source().refuse(node->source(),
                         fmt::format("invalid {} = [{}, {}] m (must be from less than to)",
                                     zone.full_name(key), from, to));
}

// One number for every two zones, or all of them as a matrix
MatXd read_coherence(const Section& sea, Index count) {
  const toml::node& node = sea.require(
      "coherence", "required: 0 to 1 between any two zones, or a list of lists, one a zone");
  if (!node.is_array()) return wave::uniform_coherence(count, sea.number("coherence", kCoherence));
  const auto refuse = [&](const std::string& why) {
    sea.source().refuse(node.source(),
                        fmt::format("invalid {} ({})", sea.full_name("coherence"), why));
  };
  const toml::array& rows = *node.as_array();
  const std::string square = fmt::format("must be {} lists of {} numbers", count, count);
  if (static_cast<Index>(rows.size()) != count) refuse(square);
  MatXd coherence(count, count);
  for (Index i = 0; i < count; ++i) {
    const toml::array* row = rows[static_cast<std::size_t>(i)].as_array();
    if (!row || static_cast<Index>(row->size()) != count) refuse(square);
    for (Index j = 0; j < count; ++j)
      coherence(i, j) = checked_number((*row)[static_cast<std::size_t>(j)],
                                       fmt::format("{}[{}][{}]", sea.full_name("coherence"), i, j),
                                       kCoherence, sea.source());
  }
  try {
    wave::coherence_factor(coherence);
  } catch (const InputError& error) {
    refuse(error.what());
  }
  return coherence;
}

}  // namespace

const std::vector<std::string>& measured_keys() {
  static const std::vector<std::string> keys = {
      "file",          "time_index",      "site_index",      "x_axis_bearing_deg",
      "density_units", "frequency_units", "direction_units", "directions"};
  return keys;
}

const std::vector<std::string>& zone_keys() {
  static const std::vector<std::string> keys = {"coherence", "transition"};
  return keys;
}

void refuse_keys_without(const Section& sea, const std::string& owner,
                         const std::vector<std::string>& keys) {
  for (const std::string& key : keys)
    if (sea.find(key))
      sea.source().refuse(sea.find(key)->source(),
                          fmt::format("unused {} (it belongs to {})", sea.full_name(key), owner));
}

void read_measured(const Section& sea, const std::filesystem::path& folder, wave::SeaState& state) {
  for (const char* key : {"partition", "zone"})
    if (sea.find(key))
      sea.source().refuse(sea.find(key)->source(),
                          fmt::format("unused {} (a measured sea has none)", sea.full_name(key)));
  std::vector<std::string> others = spectrum_keys();
  others.erase(others.begin());  // the kind itself
  refuse_keys_of_others(sea, "spectrum", "measured", others, measured_keys());

  // Read and convert it
  const MeasuredRequest request = read_request(sea);
  sea.require("file", "required: a netCDF file in the convention of wavespectra");
  const std::filesystem::path path = folder / sea.text_or("file", "");
  MeasuredSea measured;
  try {
    measured = measured_sea(read_stored_spectrum(path, request), request);
  } catch (const DataError& error) {
    const std::string why = error.what();
    const bool named = why.starts_with(path.string());
    sea.source().refuse(sea.find("file")->source(),
                        named ? why : fmt::format("{}: {}", path.string(), why));
  }
  for (const std::string& notice : measured.notices)
    sea.source().notices.push_back(fmt::format("sea {}: {}", state.name, notice));
  sea.source().files[sea.full_name("file")] = path;
  state.description = measured.description;

  // Its directions, or those that the case gives to a spectrum without any
  if (!measured.directional) {
    refuse_keys_without(sea, "spectra with directions; this file has none",
                        {"x_axis_bearing_deg", "directions", "direction_units"});
    state.partitions.push_back({*measured.spectrum, read_spreading(sea)});
    state.description += ", spreading " + spreading_words(sea);
    for (const double heading : sea.numbers("mean_heading_deg", heading_rule()).value)
      state.mean_heading_deg.push_back(heading);
    return;
  }
  std::vector<std::string> given = spreading_keys();
  given.emplace_back("mean_heading_deg");
  refuse_keys_without(sea, "spectra without directions; this file has its own", given);
  const double mean = measured.directional->mean_heading() * 180.0 / std::numbers::pi;
  state.mean_heading_deg = {std::round(10.0 * mean) / 10.0};
  state.partitions.push_back(
      {*measured.spectrum, wave::Spreading::none(), 0.0, std::move(measured.directional)});
}

void read_zones(const Section& sea, const toml::array& list, wave::SeaState& state) {
  if (sea.find("partition"))
    sea.source().refuse(
        sea.find("partition")->source(),
        fmt::format("unused {} (a sea with zones has none)", sea.full_name("partition")));
  const auto count = static_cast<Index>(list.size());
  wave::Zones zones;
  zones.transition = sea.number("transition", {"m", "must be positive", is_positive});
  zones.coherence = read_coherence(sea, count);
  const wave::Spreading spreading = read_spreading(sea);
  std::vector<std::string> known = spectrum_keys();
  known.insert(known.end(), {"x", "y"});
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Section zone(*list[i].as_table(), fmt::format("{}.zone[{}]", sea.name(), i), sea.source(),
                       known);
    wave::ZoneBounds bounds;
    read_extent(zone, "x", bounds.x_from, bounds.x_to);
    read_extent(zone, "y", bounds.y_from, bounds.y_to);
    zones.bounds.push_back(bounds);
    state.partitions.push_back({read_spectrum(zone), spreading});
    state.description += fmt::format("{}{} in x = {} … {}, y = {} … {} m", i == 0 ? "" : "; ",
                                     spectrum_words(zone, state.partitions.back().spectrum),
                                     bounds.x_from, bounds.x_to, bounds.y_from, bounds.y_to);
  }
  std::string related;
  for (Index i = 0; i < count; ++i)
    for (Index j = i + 1; j < count; ++j)
      related += fmt::format("{}{}", related.empty() ? "" : ", ", zones.coherence(i, j));
  state.description += fmt::format(", transition {} m, coherence [{}], spreading {}",
                                   zones.transition, related, spreading_words(sea));
  state.zones = std::move(zones);
}

}  // namespace floe::io
