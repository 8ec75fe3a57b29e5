#include "io/measured_spectrum.hpp"

#include "io/netcdf_file.hpp"
#include "test_case.hpp"

#include <floe/io/case_file.hpp>
#include <floe/numeric/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace floe::io {
namespace {

using test::kCaseText;
using test::TestFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kPi = std::numbers::pi;

// 12 frequencies [Hz], 24 directions [°]: 2 m² s in each direction's 15° of a quarter around one
// direction, a triangle over the frequency
StoredSpectrum stored_around(double direction) {
  StoredSpectrum stored;
  for (int i = 0; i < 12; ++i) stored.frequency.push_back(0.05 + 0.01 * i);
  for (int j = 0; j < 24; ++j) stored.direction.push_back(15.0 * j);
  for (const double frequency : stored.frequency)
    for (const double value : stored.direction) {
      const double away = std::abs(std::remainder(value - direction, 360.0));
      const double shape = std::max(0.0, 1.0 - std::abs(frequency - 0.1) / 0.04);
      stored.density.push_back(away < 46.0 ? 0.02 * shape * (1.0 - away / 60.0) : 0.0);
    }
  stored.density_units = "m2 s degree-1";
  stored.frequency_units = "Hz";
  stored.direction_units = "degree";
  stored.direction_name = "sea_surface_wave_from_direction ";
  return stored;
}

// ∫∫ E df dθ by hand: both are piecewise linear, so that sums times steps are exact
double energy_of(const StoredSpectrum& stored) {
  double sum = 0.0;
  for (const double value : stored.density) sum += value * 0.01 * 15.0;
  return sum;
}

const MeasuredRequest kEast{.x_axis_bearing_deg = 90.0};  // +x to the east, +y to the north

double heading_deg(const StoredSpectrum& stored, const MeasuredRequest& request) {
  return measured_sea(stored, request).directional->mean_heading() * 180.0 / kPi;
}

TEST(MeasuredSea, TurnsDirectionsIntoTheFrameOfTheStructure) {
  // Waves from the west travel to the east, along +x; from the south to the north, along +y
  EXPECT_NEAR(heading_deg(stored_around(270.0), kEast), 0.0, 1e-9);
  EXPECT_NEAR(heading_deg(stored_around(180.0), kEast), 90.0, 1e-9);
  EXPECT_NEAR(std::abs(heading_deg(stored_around(90.0), kEast)), 180.0, 1e-9);
  // +x to the north: what comes from the west goes to -y
  EXPECT_NEAR(heading_deg(stored_around(270.0), {.x_axis_bearing_deg = 0.0}), -90.0, 1e-9);
  // What goes to the east is what comes from the west
  StoredSpectrum going = stored_around(90.0);
  going.direction_name = "sea_surface_wave_to_direction ";
  EXPECT_NEAR(heading_deg(going, kEast), 0.0, 1e-9);
}

TEST(MeasuredSea, KeepsTheEnergyInEveryUnit) {
  const StoredSpectrum stored = stored_around(200.0);
  const MeasuredSea sea = measured_sea(stored, kEast);
  EXPECT_NEAR(sea.spectrum->m0(), energy_of(stored), 1e-12);
  EXPECT_THAT(sea.notices, IsEmpty());

  StoredSpectrum radians = stored;
  for (double& value : radians.density) value *= 180.0 / kPi;
  for (double& value : radians.direction) value *= kPi / 180.0;
  radians.density_units = "m2 s rad-1";
  radians.direction_units = "radian";
  const MeasuredSea same = measured_sea(radians, kEast);
  EXPECT_NEAR(same.spectrum->m0(), energy_of(stored), 1e-12);
  EXPECT_NEAR(same.directional->mean_heading(), sea.directional->mean_heading(), 1e-9);
  // S(ω, θ) at 0.1 Hz in the direction of most energy: 0.02 m² s/° is 0.02 · 180/π / 2π
  const VecXd density = sea.directional->density(2.0 * kPi * 0.1);
  const double share = 1.0 - 5.0 / 60.0;  // the nearest direction is 195°
  EXPECT_NEAR(density.maxCoeff(), share * 0.02 * 180.0 / kPi / (2.0 * kPi), 1e-12);

  for (const char* unit : {"m^{2}.s.degree^{-1}", "m2/Hz/degree", "m**2 s deg**-1", "m2 s deg-1"}) {
    StoredSpectrum spelt = stored;
    spelt.density_units = unit;
    EXPECT_NEAR(measured_sea(spelt, kEast).spectrum->m0(), energy_of(stored), 1e-12) << unit;
  }
}

TEST(MeasuredSea, WithoutDirectionsIsASpectrum) {
  StoredSpectrum stored;
  stored.frequency = {0.05, 0.1, 0.15};
  stored.density = {0.0, 4.0, 0.0};
  stored.density_units = "m2 s";
  stored.frequency_units = "s-1";
  const MeasuredSea sea = measured_sea(stored, {});
  EXPECT_FALSE(sea.directional);
  EXPECT_NEAR(sea.spectrum->m0(), 0.5 * 0.1 * 4.0, 1e-12);
}

TEST(MeasuredSea, RepairsWhatIsPlainAndSaysSo) {
  const StoredSpectrum good = stored_around(200.0);
  const double m0 = measured_sea(good, kEast).spectrum->m0();

  // 360° beside 0°, as it was copied
  StoredSpectrum closed = stored_around(200.0);
  closed.direction.push_back(360.0);
  closed.density.clear();
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t j = 0; j < 24; ++j) closed.density.push_back(good.density[i * 24 + j]);
    closed.density.push_back(good.density[i * 24]);
  }
  const MeasuredSea once = measured_sea(closed, kEast);
  EXPECT_THAT(once.notices, ElementsAre("1 directions that were given twice were dropped"));
  EXPECT_NEAR(once.spectrum->m0(), m0, 1e-12);

  // Any order of frequencies and directions
  StoredSpectrum mixed = good;
  std::swap(mixed.frequency[2], mixed.frequency[7]);
  std::swap(mixed.direction[3], mixed.direction[12]);
  for (std::size_t j = 0; j < 24; ++j)
    std::swap(mixed.density[2 * 24 + j], mixed.density[7 * 24 + j]);
  for (std::size_t i = 0; i < 12; ++i)
    std::swap(mixed.density[i * 24 + 3], mixed.density[i * 24 + 12]);
  const MeasuredSea sorted = measured_sea(mixed, kEast);
  EXPECT_THAT(sorted.notices,
              ElementsAre("the frequencies were sorted", "the directions were sorted"));
  EXPECT_NEAR(sorted.spectrum->m0(), m0, 1e-12);
  EXPECT_NEAR(sorted.directional->mean_heading(), heading_deg(good, kEast) * kPi / 180.0, 1e-12);

  StoredSpectrum rounded = good;
  rounded.density[0] = -1e-12;
  EXPECT_THAT(measured_sea(rounded, kEast).notices.at(0),
              HasSubstr("1 values of efth below 0 by rounding"));
}

std::string refusal(const std::function<void(StoredSpectrum&, MeasuredRequest&)>& spoil) {
  StoredSpectrum stored = stored_around(200.0);
  MeasuredRequest request = kEast;
  spoil(stored, request);
  try {
    measured_sea(stored, request);
  } catch (const DataError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(MeasuredSea, AsksForWhatTheFileDoesNotSay) {
  EXPECT_THAT(refusal([](auto& stored, auto&) { stored.density_units = ""; }),
              HasSubstr("does not say the units of efth (give density_units = \"m2 s degree-1\" or "
                        "\"m2 s rad-1\")"));
  EXPECT_THAT(refusal([](auto& stored, auto&) { stored.frequency_units = ""; }),
              HasSubstr("the units of the frequencies (give frequency_units = \"Hz\")"));
  EXPECT_THAT(refusal([](auto& stored, auto&) { stored.direction_units = ""; }),
              HasSubstr("(give direction_units = \"degree\" or \"rad\")"));
  EXPECT_THAT(refusal([](auto& stored, auto&) { stored.direction_name = "dir "; }),
              HasSubstr("(give directions = \"coming-from\" or \"going-to\")"));
  EXPECT_THAT(refusal([](auto&, auto& request) { request.x_axis_bearing_deg.reset(); }),
              HasSubstr("missing x_axis_bearing_deg"));
  // What is given counts where the file is silent
  EXPECT_EQ(refusal([](auto& stored, auto& request) {
              stored.density_units = stored.direction_name = "";
              request.density_units = "m2 s degree-1";
              request.directions = "coming-from";
            }),
            "accepted");
}

TEST(MeasuredSea, RefusesContradictions) {
  EXPECT_THAT(
      refusal([](auto&, auto& request) { request.density_units = "m2 s rad-1"; }),
      HasSubstr("density_units = \"m2 s rad-1\", but the file has efth in \"m2 s degree-1"));
  EXPECT_THAT(refusal([](auto&, auto& request) { request.directions = "going-to"; }),
              HasSubstr("directions = \"going-to\", but the file says \"sea_surface_wave_from"));
  EXPECT_THAT(refusal([](auto& stored, auto&) { stored.density_units = "m2 s"; }),
              HasSubstr("unknown units \"m2 s\" of efth in the file"));
  EXPECT_THAT(refusal([](auto& stored, auto&) { stored.frequency_units = "rad/s"; }),
              HasSubstr("unknown units \"rad/s\" of the frequencies"));
}

TEST(MeasuredSea, RefusesWhatIsNoSpectrum) {
  EXPECT_THAT(refusal([](auto& stored, auto&) { stored.density[5] = NAN; }),
              HasSubstr("1 of the 288 values of efth are missing or not finite"));
  EXPECT_THAT(refusal([](auto& stored, auto&) { stored.density[5] = 9.96921e36; }),
              HasSubstr("1 of the 288 values of efth are missing"));
  EXPECT_THAT(refusal([](auto& stored, auto&) { stored.density[5] = -0.01; }),
              HasSubstr("1 values of efth are negative, down to -0.01"));
  EXPECT_THAT(refusal([](auto& stored, auto&) {
                std::fill(stored.density.begin(), stored.density.end(), 0.0);
              }),
              HasSubstr("holds no energy"));
  EXPECT_THAT(refusal([](auto& stored, auto&) { stored.frequency[3] = stored.frequency[4]; }),
              HasSubstr("Hz is given twice"));
  EXPECT_THAT(refusal([](auto& stored, auto&) { stored.frequency[0] = -0.01; }),
              HasSubstr("Hz is negative"));
  EXPECT_THAT(refusal([](auto& stored, auto&) { stored.direction[3] = NAN; }),
              HasSubstr("a value of the directions is missing"));
  EXPECT_THAT(refusal([](auto& stored, auto&) { stored.direction[13] = 360.0 + 180.0; }),
              HasSubstr("a direction is given twice with different values"));
  EXPECT_THAT(refusal([](auto& stored, auto&) {
                for (double& value : stored.direction) value *= 0.5;
              }),
              HasSubstr("the directions leave out 188° (must go round the circle)"));
}

// A file in the convention of wavespectra: three times, two sites; the wanted one is (1, 1)
void write_file(const std::filesystem::path& path, bool native = false) {
  const StoredSpectrum stored = stored_around(native ? 90.0 : 270.0);
  const std::string freq = native ? "frequency" : "freq", dir = native ? "direction" : "dir";
  const std::string site = native ? "station" : "site";
  NetcdfFile file = NetcdfFile::create(path);
  file.add_dimension("time", 3);
  file.add_dimension(site, 2);
  file.add_dimension(freq, 12);
  file.add_dimension(dir, 24);
  file.add_numbers(freq, {freq}, stored.frequency);
  file.add_numbers(dir, {dir}, stored.direction);
  std::vector<double> all;
  for (int place = 0; place < 6; ++place)
    for (const double value : stored.density)
      all.push_back((place == 3 ? 1.0 : 0.25) * value * (native ? 180.0 / kPi : 1.0));
  file.add_numbers("efth", {"time", site, freq, dir}, all, Compression::kDeflate);
  file.add_attribute("efth", "units", native ? "m2 s rad-1" : "m2 s degree-1");
  file.add_attribute(freq, "units", native ? "s-1" : "Hz");
  file.add_attribute(dir, "units", "degree");
  file.add_attribute(dir, "standard_name",
                     native ? "sea_surface_wave_to_direction" : "sea_surface_wave_from_direction");
  file.close();
}

const MeasuredRequest kPlace{.time_index = 1, .site_index = 1, .x_axis_bearing_deg = 90.0};

TEST(StoredSpectrumFile, IsReadInBothConventions) {
  const TestFolder folder;
  for (const bool native : {false, true}) {
    const auto path = folder.path() / (native ? "ww3.nc" : "ws.nc");
    write_file(path, native);
    const MeasuredSea sea = measured_sea(read_stored_spectrum(path, kPlace), kPlace);
    EXPECT_NEAR(sea.spectrum->m0(), energy_of(stored_around(270.0)), 1e-10) << native;
    EXPECT_NEAR(sea.directional->mean_heading(), 0.0, 1e-9) << native;
  }
}

TEST(StoredSpectrumFile, MayHaveItsDimensionsInAnyOrder) {
  const TestFolder folder;
  const auto path = folder.path() / "turned.nc";
  const StoredSpectrum stored = stored_around(270.0);
  NetcdfFile file = NetcdfFile::create(path);
  file.add_dimension("dir", 24);
  file.add_dimension("freq", 12);
  file.add_numbers("freq", {"freq"}, stored.frequency);
  file.add_numbers("dir", {"dir"}, stored.direction);
  std::vector<double> turned;
  for (std::size_t j = 0; j < 24; ++j)
    for (std::size_t i = 0; i < 12; ++i) turned.push_back(stored.density[i * 24 + j]);
  file.add_numbers("efth", {"dir", "freq"}, turned);
  file.close();
  EXPECT_EQ(read_stored_spectrum(path, {}).density, stored.density);
}

std::string file_refusal(const std::filesystem::path& path, const MeasuredRequest& request) {
  try {
    read_stored_spectrum(path, request);
  } catch (const DataError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(StoredSpectrumFile, NamesWhatIsMissing) {
  const TestFolder folder;
  const auto path = folder.path() / "ws.nc";
  write_file(path);
  EXPECT_THAT(file_refusal(path, {}), HasSubstr("ws.nc: time has 3 entries (give time_index, 0 to "
                                                "2)"));
  EXPECT_THAT(file_refusal(path, {.time_index = 1}), HasSubstr("site has 2 entries (give site_in"));
  EXPECT_THAT(file_refusal(path, {.time_index = 3, .site_index = 0}),
              HasSubstr("invalid time_index = 3 (time has 3 entries, from 0)"));
  EXPECT_THAT(file_refusal(folder.path() / "none.nc", {}), HasSubstr("not a regular file"));
  EXPECT_THAT(file_refusal(folder.path(), {}), HasSubstr("not a regular file"));
  ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(file_refusal(folder.path() / "pipe", {}), HasSubstr("not a regular file"));
  EXPECT_THAT(file_refusal(folder.write("text.nc", "no netCDF"), {}),
              HasSubstr("text.nc: cannot read: NetCDF: "));

  const auto empty = folder.path() / "empty.nc";
  NetcdfFile file = NetcdfFile::create(empty);
  file.add_dimension("x", 2);
  file.add_numbers("hs", {"x"}, std::vector<double>{1.0, 2.0});
  file.close();
  EXPECT_THAT(file_refusal(empty, {}), HasSubstr("no variable efth (must follow the convention of"
                                                 " wavespectra or WAVEWATCH III; holds hs)"));
}

TEST(StoredSpectrumFile, MayBeDamagedInEveryWay) {
  // Cut off anywhere, or with bits flipped: read (the flip was in a value or in nothing) or
  // refused, while this process lives
  const TestFolder folder;
  write_file(folder.path() / "ws.nc");
  const std::string whole = folder.read("ws.nc");
  int refused = 0;
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 24)
    refused += file_refusal(folder.write("cut.nc", whole.substr(0, at)), kPlace) != "accepted";
  EXPECT_GE(refused, 24);
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 160) {
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << (at % 8)));
    const auto path = folder.write("flipped.nc", flipped);
    try {
      const MeasuredSea sea = measured_sea(read_stored_spectrum(path, kPlace), kPlace);
      EXPECT_TRUE(std::isfinite(sea.spectrum->m0()));
    } catch (const DataError&) {
    }
  }
}

TEST(StoredSpectrumFile, CannotSwellTheProgram) {
  // Unwritten variables take no room on the disk: 2e5 × 2e5 numbers are 320 GB in memory
  const TestFolder folder;
  const auto path = folder.path() / "bomb.nc";
  NetcdfFile file = NetcdfFile::create(path);
  file.add_dimension("freq", 200'000);
  file.add_dimension("dir", 200'000);
  file.define_numbers("efth", {"freq", "dir"}, Compression::kDeflate);
  file.close();
  ASSERT_LT(std::filesystem::file_size(path), 1'000'000u);
  EXPECT_THAT(file_refusal(path, {}), HasSubstr("a spectrum of more than 4000000 values"));
}

const std::string kSea = R"([[sea]]
name = "buoy"
spectrum = "measured"
file = "ws.nc"
time_index = 1
site_index = 1
x_axis_bearing_deg = 90
)";

TEST(MeasuredSection, IsASeaOfTheCase) {
  const TestFolder folder;
  write_file(folder.path() / "ws.nc");
  const CaseFile file = read_case(folder.write("case.toml", kCaseText + kSea));
  ASSERT_EQ(file.data.seas.size(), 1u);
  const wave::SeaState& sea = file.data.seas[0];
  EXPECT_THAT(sea.mean_heading_deg, ElementsAre(0.0));
  EXPECT_NEAR(sea.m0(), energy_of(stored_around(270.0)), 1e-10);
  EXPECT_THAT(sea.description,
              HasSubstr("measured (time 1, site 1, 12 frequencies, 24 directions"));
  ASSERT_TRUE(sea.partitions.at(0).measured);
}

TEST(MeasuredSection, NamesTheFaultAndItsPlace) {
  const TestFolder folder;
  write_file(folder.path() / "ws.nc");
  const auto refused = [&](const std::string& text) -> std::string {
    try {
      read_case(folder.write("case.toml", kCaseText + text));
    } catch (const DataError& error) {
      return error.what();
    }
    return "accepted";
  };
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_THAT(refused(changed(kSea, "time_index = 1\n", "")),
              HasSubstr("ws.nc: time has 3 entries (give time_index, 0 to 2)"));
  EXPECT_THAT(refused(changed(kSea, "x_axis_bearing_deg = 90\n", "")),
              HasSubstr("ws.nc: missing x_axis_bearing_deg (required: degrees from north"));
  EXPECT_THAT(refused(changed(kSea, "file = \"ws.nc\"\n", "")),
              HasSubstr("missing sea[0].file (required: a netCDF file in the convention of wav"));
  EXPECT_THAT(
      refused(kSea + "mean_heading_deg = [0]\n"),
      HasSubstr("unused sea[0].mean_heading_deg (it belongs to spectra without directions"));
  EXPECT_THAT(refused(kSea + "gamma = 2\n"), HasSubstr("unused sea[0].gamma (a spectrum = \"meas"));
  EXPECT_THAT(refused(changed(kSea, "\"measured\"", "\"jonswap\"")),
              HasSubstr("unused sea[0].file (it belongs to spectrum = \"measured\")"));
}

}  // namespace
}  // namespace floe::io
