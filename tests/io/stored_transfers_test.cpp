#include "test_case.hpp"

#include <floe/analysis.hpp>
#include <floe/io/directory_store.hpp>
#include <floe/io/stored_transfers.hpp>
#include <floe/numeric/error.hpp>
#include <floe/sea_statistics.hpp>

#include <expect.hpp>
#include <gtest/gtest.h>
#include <recorded_run.hpp>

#include <cmath>

namespace floe::io {
namespace {

using response::Quantity;

Case small_case() {
  Case data = test::table1_case(16, 4);
  data.mode_count = 8;
  data.omega = {0.4};
  data.heading_deg = {0.0};
  data.lines = {{"centre", {-150.0, 0.0}, {150.0, 0.0}, 5}};
  data.quantities = {Quantity::kDeflection, Quantity::kAcceleration, Quantity::kBendingMomentX,
                     Quantity::kPressure};
  return data;
}

wave::SeaState swell() {
  return {.name = "swell",
          .description = "",
          .partitions = {{wave::Spectrum::bretschneider(2.0, 14.0),
                          wave::Spreading::cosine_power(2.0)}},
          .mean_heading_deg = {0.0, 40.0},
          .allow_truncation = true};
}

void store(const Case& data, const std::filesystem::path& path) {
  test::RecordedRun unused;
  test::RecordingLog log(unused);
  DirectoryStore store(path);
  analyse(data, log, store);
}

std::vector<SeaResult> statistics(const StoredTransfers& transfers) {
  SeaStatistics sums({swell()}, transfers.observation(), transfers.grid().omega,
                     transfers.grid().headings);
  for (std::size_t i = 0; i < transfers.grid().omega.size(); ++i) sums.add(transfers.transfer(i));
  return sums.results();
}

TEST(twin_StoredTransfers, OfTheWavesGiveTheStatisticsOfTheSeasOwn) {
  const test::TestFolder folder;
  Case data = small_case();
  data.sea_grid = {.from = 0.4, .to = 0.5, .tolerance = 1e-4};
  store(data, folder.path() / "seas.out");
  const StoredRun seas_run(folder.path() / "seas.out");
  const StoredTransfers own(seas_run);

  data.sea_grid = {};
  data.omega = own.grid().omega;
  data.heading_deg.clear();
  // In another order, some below zero
  for (int b = 0; b < own.grid().headings; ++b) {
    const double degrees = 360.0 * b / own.grid().headings;
    data.heading_deg.push_back(degrees > 180.0 ? degrees - 360.0 : degrees);
  }
  store(data, folder.path() / "waves.out");
  const StoredRun waves_run(folder.path() / "waves.out");
  const StoredTransfers of_waves(waves_run);
  EXPECT_EQ(of_waves.grid().headings, own.grid().headings);
  EXPECT_TRUE(of_waves.warnings().empty());

  // By a diffraction problem instead of reciprocity: they differ by the discretisation
  const std::vector<SeaResult> expected = statistics(own), actual = statistics(of_waves);
  ASSERT_EQ(actual.size(), 2u);
  for (std::size_t s = 0; s < actual.size(); ++s) {
    for (std::size_t q = 0; q < data.quantities.size(); ++q)
      EXPECT_LE(test::relative_error(actual[s].moments[q], expected[s].moments[q]), 2e-2)
          << s << " " << q;
    EXPECT_LE(test::relative_error(actual[s].line_deviation, expected[s].line_deviation), 5e-3);
    EXPECT_LE(test::relative_error(actual[s].node_moments, expected[s].node_moments), 1e-2);
  }
}

TEST(StoredTransfers, RefuseHeadingsThatDoNotGoAroundTheCircleAndTellOfTooFew) {
  const test::TestFolder folder;
  Case data = small_case();
  data.omega = {0.4, 0.45};
  data.heading_deg = {0.0, 90.0, 180.0};
  store(data, folder.path() / "three.out");
  const StoredRun three(folder.path() / "three.out");
  EXPECT_THROW(StoredTransfers{three}, StoreError);
  data.heading_deg = {0.0, 90.0, 180.0, 270.0};
  store(data, folder.path() / "four.out");
  const StoredRun four(folder.path() / "four.out");
  EXPECT_EQ(StoredTransfers(four).warnings().size(), 1u);
}

}  // namespace
}  // namespace floe::io
