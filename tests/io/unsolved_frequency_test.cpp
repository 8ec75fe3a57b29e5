#include "csv.hpp"
#include "fabricated_results.hpp"
#include "io/netcdf_file.hpp"
#include "test_case.hpp"

#include <floe/estimate.hpp>
#include <floe/io/directory_store.hpp>
#include <floe/io/stored_run.hpp>
#include <floe/unsolved_frequency.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace floe::io {
namespace {

using test::small_case;
using test::small_mesh;
using test::small_modes;
using test::small_result;
using test::TestFolder;
using testing::ElementsAre;

TEST(UnsolvedFrequency, IsFlaggedInEveryProductAndTriedAgain) {
  const TestFolder folder;
  const std::filesystem::path out = folder.path() / "out";
  const mesh::Q8Mesh mesh = small_mesh();
  const auto begin = [&](DirectoryStore& store) {
    store.begin(small_case(), mesh, estimate(small_case(), mesh, nullptr, 1));
    store.modes(small_modes(), mesh);
  };
  {
    DirectoryStore store(out);
    begin(store);
    store.frequency(small_result(0.4));
    store.frequency(unsolved_frequency(small_case(), 4, 0.5, "omega = 0.5 rad/s: it failed"));
    store.finish({});
    store.stop("this comes after the end");
  }
  const auto run = nlohmann::json::parse(folder.read("out/run.json"));
  EXPECT_EQ(run.at("status"), "failed");
  EXPECT_EQ(run.at("frequencies").at(1).at("status"), "failed");
  EXPECT_EQ(run.at("frequencies").at(1).at("failure"), "omega = 0.5 rad/s: it failed");
  for (const char* name : {"rao_points.csv", "rao_lines.csv", "rao_quantities.csv",
                           "wave_points.csv", "hydro_coefficients.csv", "exciting_force.csv"}) {
    const test::CsvTable table = test::read_csv(out / name);
    const std::vector<std::string> omega = table.strings("omega");
    const std::vector<std::string> last = table.strings(table.names().back());
    EXPECT_EQ(std::count(omega.begin(), omega.end(), "0.5"), std::ssize(omega) / 2) << name;
    for (std::size_t i = 0; i < omega.size(); ++i)
      EXPECT_EQ(last[i] == "nan", omega[i] == "0.5") << name << ", row " << i;
  }
  const NetcdfFile file = NetcdfFile::open(out / "result.nc");
  EXPECT_THAT(file.numbers("status"), ElementsAre(0, 1));
  EXPECT_THAT(file.numbers("omega"), ElementsAre(0.4, 0.5));
  for (const char* name : {"added_mass", "radiation_damping"}) {
    const std::vector<double> values = file.numbers(name);
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_EQ(std::isnan(values[i]), i >= values.size() / 2) << name << ", " << i;
  }

  // Read back, and tried again
  const StoredRun stored(out);
  EXPECT_FALSE(stored.has_frequency(1));
  EXPECT_EQ(stored.failure(0), "");
  EXPECT_EQ(stored.failure(1), "omega = 0.5 rad/s: it failed");
  EXPECT_EQ(stored.frequencies().size(), 1u);
  ASSERT_EQ(stored.results().frequencies.size(), 2u);
  EXPECT_TRUE(std::isnan(stored.results().frequencies[1].amplitudes(0, 0).real()));
  {
    DirectoryStore store(out, Existing::kResume);
    begin(store);
    EXPECT_TRUE(store.known_frequency(0).has_value());
    EXPECT_FALSE(store.known_frequency(1).has_value());
    store.frequency(small_result(0.4));
    store.frequency(small_result(0.5));
    store.finish({});
  }
  EXPECT_EQ(nlohmann::json::parse(folder.read("out/run.json")).at("status"), "complete");
  EXPECT_FALSE(std::filesystem::exists(out / "records/failure_00002.rec"));
  EXPECT_EQ(StoredRun(out).failure(1), "");
}

}  // namespace
}  // namespace floe::io
