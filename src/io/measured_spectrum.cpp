#include "io/measured_spectrum.hpp"

#include "io/child_process.hpp"
#include "io/netcdf_file.hpp"

#include <floe/numeric/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>

namespace floe::io {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostValues = 4'000'000;  // of one spectrum
constexpr const char* kDensity = "efth";

bool is_one_of(const std::string& name, std::initializer_list<const char*> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Which part of `efth` is wanted, dimension by dimension
struct Selection {
  std::vector<std::size_t> start, count;
  std::string frequency, direction;  // names; no direction: ""
  bool direction_first = false;
};

std::size_t chosen_index(const std::string& dimension, std::size_t length,
                         const std::optional<std::size_t>& wanted, const char* key) {
  if (!wanted && length != 1)
    throw DataError(fmt::format("{} has {} entries (give {}, 0 to {})", dimension, length, key,
                                length == 0 ? 0 : length - 1));
  if (wanted.value_or(0) >= length)
    throw DataError(fmt::format("invalid {} = {} ({} has {} entries, from 0)", key,
                                wanted.value_or(0), dimension, length));
  return wanted.value_or(0);
}

Selection select(const NetcdfFile& file, const MeasuredRequest& request) {
  const std::vector<std::string> names = file.dimensions(kDensity);
  const std::vector<std::size_t> lengths = file.shape(kDensity);
  Selection chosen;
  for (std::size_t d = 0; d < names.size(); ++d) {
    std::size_t start = 0, count = 1;
    if (is_one_of(names[d], {"freq", "frequency"})) {
      chosen.frequency = names[d];
      count = lengths[d];
    } else if (is_one_of(names[d], {"dir", "direction"})) {
      chosen.direction = names[d];
      chosen.direction_first = chosen.frequency.empty();
      count = lengths[d];
    } else if (names[d] == "time") {
      start = chosen_index(names[d], lengths[d], request.time_index, "time_index");
    } else if (is_one_of(names[d], {"site", "station"})) {
      start = chosen_index(names[d], lengths[d], request.site_index, "site_index");
    } else if (lengths[d] != 1) {
      throw DataError(
          fmt::format("efth has {} entries along {} (must be one spectrum for a time "
                      "and a site; take one out first)",
                      lengths[d], names[d]));
    }
    chosen.start.push_back(start);
    chosen.count.push_back(count);
  }
  if (chosen.frequency.empty())
    throw DataError(fmt::format("efth has the dimensions {} (must have freq or frequency)",
                                fmt::join(names, ", ")));
  std::size_t values = 1;
  for (const std::size_t count : chosen.count) {
    values *= std::min(count, kMostValues + 1);
    if (values > kMostValues)
      throw DataError(fmt::format("a spectrum of more than {} values", kMostValues));
  }
  return chosen;
}

std::vector<double> coordinate(const NetcdfFile& file, const std::string& name) {
  if (!file.holds(name))
    throw DataError(fmt::format("no variable {} for the dimension of that name", name));
  if (file.dimensions(name) != std::vector<std::string>{name})
    throw DataError(fmt::format("the variable {} must have the dimension of that name", name));
  return file.unpacked_numbers(name);
}

Json read_in_child(const std::filesystem::path& path, const MeasuredRequest& request) {
  const NetcdfFile file = NetcdfFile::open(path);
  if (!file.holds(kDensity))
    throw DataError(
        fmt::format("no variable efth (must follow the convention of wavespectra or "
                    "WAVEWATCH III; holds {})",
                    fmt::join(file.variables(), ", ")));
  const Selection chosen = select(file, request);
  const auto words = [&](const std::string& variable, const char* attribute) {
    return variable.empty() ? "" : file.attribute_text(variable, attribute).value_or("");
  };
  Json said = {{"frequency", coordinate(file, chosen.frequency)},
               {"direction", std::vector<double>{}},
               {"density", file.unpacked_numbers(kDensity, chosen.start, chosen.count)},
               {"direction_first", chosen.direction_first},
               {"units",
                {words(kDensity, "units"), words(chosen.frequency, "units"),
                 words(chosen.direction, "units")}},
               {"name", words(chosen.direction, "standard_name") + " " +
                            words(chosen.direction, "long_name")}};
  if (!chosen.direction.empty()) said["direction"] = coordinate(file, chosen.direction);
  return said;
}

std::string as_text(const Json& said) {
  const std::vector<std::uint8_t> bytes = Json::to_cbor(said);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

StoredSpectrum read_stored_spectrum(const std::filesystem::path& path,
                                    const MeasuredRequest& request) try {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown))
    throw DataError("not a regular file, or none that can be read");
  const Json said =
      Json::from_cbor(run_in_child([&] { return as_text(read_in_child(path, request)); }));
  StoredSpectrum stored{said.at("frequency"),   said.at("direction"),   said.at("density"),
                        said.at("units").at(0), said.at("units").at(1), said.at("units").at(2),
                        said.at("name")};
  const std::size_t rows = stored.frequency.size(), columns = stored.direction.size();
  if (stored.density.size() != rows * std::max<std::size_t>(columns, 1))
    throw DataError(fmt::format("efth has {} values for {} frequencies and {} directions",
                                stored.density.size(), rows, columns));
  if (said.at("direction_first") && columns > 0) {
    std::vector<double> turned(stored.density.size());
    for (std::size_t j = 0; j < columns; ++j)
      for (std::size_t i = 0; i < rows; ++i) turned[i * columns + j] = stored.density[j * rows + i];
    stored.density = std::move(turned);
  }
  return stored;
} catch (const Json::exception&) {
  throw DataError(path.string() + ": its reader gave nothing that can be used");
} catch (const InputError& error) {
  std::string why = error.what();
  const std::string doubled = "cannot read " + path.string() + ": ";
  if (why.starts_with(doubled)) why = "cannot read: " + why.substr(doubled.size());
  throw DataError(path.string() + ": " + why);
}

}  // namespace floe::io
