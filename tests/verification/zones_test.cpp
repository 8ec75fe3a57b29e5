#include <floe/analysis.hpp>
#include <floe/numeric/error.hpp>
#include <floe/sea_statistics.hpp>

#include <expect.hpp>
#include <gtest/gtest.h>
#include <recorded_run.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floe {
namespace {

wave::ZoneBounds between(double from, double to) {
  wave::ZoneBounds bounds;
  bounds.x_from = from;
  bounds.x_to = to;
  return bounds;
}

constexpr double kFar = 1e6;
const wave::Spreading kSpreading = wave::Spreading::cosine_power(2.0);

wave::SeaState sea_of(const std::string& name, std::vector<wave::Partition> partitions) {
  return {.name = name,
          .description = "",
          .partitions = std::move(partitions),
          .mean_heading_deg = {20.0},
          .allow_truncation = true};
}

// A uniform sea, the same as two zones that belong together, and seas that do change
const test::RecordedRun& zonal_run() {
  static const test::RecordedRun run = [] {
    Case data = test::table1_case(20, 4);
    data.mode_count = 8;
    data.plate.loss_factor = 0.05;
    data.omega = {0.5};
    data.heading_deg = {0.0};
    data.quantities = {response::Quantity::kDeflection, response::Quantity::kAcceleration,
                       response::Quantity::kBendingMomentX};
    data.sea_grid = {.from = 0.5, .to = 0.7, .tolerance = 1e-2};
    const wave::Spectrum high = wave::Spectrum::bretschneider(2.0, 9.0);
    const wave::Spectrum low = wave::Spectrum::jonswap(1.0, 11.0, 2.0);
    const std::vector<wave::ZoneBounds> halves = {between(-kFar, 20.0), between(20.0, kFar)};
    data.seas = {sea_of("uniform", {{high, kSpreading}}),
                 sea_of("one", {{high, kSpreading}, {high, kSpreading}}),
                 sea_of("two", {{high, kSpreading}, {low, kSpreading}}),
                 sea_of("three", {{high, kSpreading}, {low, kSpreading}, {high, kSpreading}})};
    data.seas[1].zones = {halves, 150.0, wave::uniform_coherence(2, 1.0)};
    data.seas[2].zones = {halves, 60.0, wave::uniform_coherence(2, 0.4)};
    MatXd coherence = wave::uniform_coherence(3, 0.3);
    coherence(0, 2) = coherence(2, 0) = 0.8;
    data.seas[3].zones = {
        {between(-kFar, -50.0), between(-50.0, 60.0), between(60.0, kFar)}, 80.0, coherence};
    return test::run(data);
  }();
  return run;
}

TEST(identity_Zones, OneSpectrumInTwoZonesThatBelongTogetherIsTheUniformSea) {
  const SeaResult &uniform = zonal_run().seas.at(0), &one = zonal_run().seas.at(1);
  ASSERT_EQ(one.sea, "one");
  for (std::size_t q = 0; q < uniform.moments.size(); ++q) {
    EXPECT_LE(test::relative_error(one.moments[q], uniform.moments[q]), 1e-10) << q;
    EXPECT_LE(test::relative_error(one.spectra[q], uniform.spectra[q]), 1e-10) << q;
  }
  EXPECT_LE(test::relative_error(one.node_moments, uniform.node_moments), 1e-10);
  EXPECT_NEAR(one.significant_height, uniform.significant_height, 1e-12);
  EXPECT_NEAR(one.share_outside, uniform.share_outside, 1e-12);
}

// S_y(ω) = ∑_b w_b ∑_zz' Γ_zz' √(S_z S_z') y_z* y_z': all pairs of zones, no factor of Γ
MatXd covariance_sum(const test::RecordedRun& run, const wave::SeaState& sea,
                     std::size_t first_zone, std::size_t quantity) {
  const auto points = static_cast<Index>(run.data.points.size());
  const auto circle = static_cast<int>(run.transfers.front().state.cols());
  const response::DirectionGrid grid = response::direction_grid(
      kSpreading, sea.mean_heading_deg.front() * std::numbers::pi / 180.0, circle);
  const response::CircleInterpolation at_headings(grid.heading, circle);
  MatXd spectra(points, static_cast<Index>(run.transfers.size()));
  for (std::size_t i = 0; i < run.transfers.size(); ++i) {
    const SeaTransfer& transfer = run.transfers[i];
    const double factor = std::pow(transfer.omega, 2 * run.observation.derivative.at(quantity));
    std::vector<MatXcd> seen;
    for (std::size_t z = 0; z < sea.partitions.size(); ++z)
      seen.push_back(
          run.observation.points.middleRows(static_cast<Index>(quantity) * points, points)
              .cast<Complex>() *
          at_headings(transfer.zone_states.at(first_zone + z)));
    for (Index p = 0; p < points; ++p) {
      Complex sum = 0.0;
      for (std::size_t b = 0; b < grid.heading.size(); ++b)
        for (std::size_t z = 0; z < seen.size(); ++z)
          for (std::size_t y = 0; y < seen.size(); ++y)
            sum += grid.weight[b] *
                   sea.zones->coherence(static_cast<Index>(z), static_cast<Index>(y)) *
                   std::sqrt(sea.partitions[z].spectrum(transfer.omega) *
                             sea.partitions[y].spectrum(transfer.omega)) *
                   std::conj(seen[z](p, static_cast<Index>(b))) * seen[y](p, static_cast<Index>(b));
      spectra(p, static_cast<Index>(i)) = factor * sum.real();
    }
  }
  return spectra;
}

TEST(twin_Zones, LowRankTermsAreTheSumOverAllPairsOfZones) {
  const test::RecordedRun& run = zonal_run();
  std::size_t first_zone = 2;  // after those of "one"
  for (const std::size_t s : {2u, 3u}) {
    const wave::SeaState& sea = run.data.seas[s];
    for (std::size_t q = 0; q < run.observation.quantity.size(); ++q)
      EXPECT_LE(
          test::relative_error(run.seas[s].spectra[q], covariance_sum(run, sea, first_zone, q)),
          1e-10)
          << sea.name << " " << q;
    first_zone += sea.partitions.size();
  }
  ASSERT_EQ(run.transfers.front().zone_states.size(), first_zone);
}

TEST(limit_Zones, ACalmHalfIsNearlyStillAndAStormyOneIsNot) {
  // Without coherence the response adds up from both zones (E.24); with a wave of 1 mm in one half
  // what is left is the other zone's share
  const test::RecordedRun& run = zonal_run();
  wave::SeaState sea = run.data.seas[2];
  sea.zones->coherence = wave::uniform_coherence(2, 0.0);
  const wave::SeaState both = sea;
  std::vector<wave::SeaState> seas = {both, both, both};
  const wave::Spectrum still = wave::Spectrum::jonswap(1e-3, 11.0, 2.0);
  seas[1].partitions[0].spectrum = still;
  seas[2].partitions[1].spectrum = still;
  std::vector<double> omega;
  for (const SeaTransfer& transfer : run.transfers) omega.push_back(transfer.omega);
  SeaStatistics statistics(seas, run.observation, omega,
                           static_cast<int>(run.transfers.front().state.cols()));
  for (SeaTransfer transfer : run.transfers) {
    const std::vector<MatXcd> own = {transfer.zone_states[2], transfer.zone_states[3]};
    transfer.zone_states = {own[0], own[1], own[0], own[1], own[0], own[1]};
    statistics.add(transfer);
  }
  const std::vector<SeaResult> results = statistics.results();
  EXPECT_LE(
      test::relative_error(results[1].moments[0] + results[2].moments[0], results[0].moments[0]),
      1e-5);
}

TEST(Zones, WarnWhereTheyChangeWithinAWavelength) {
  const auto& warnings = zonal_run().warnings;
  const auto told = [&](const std::string& sea) {
    return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& text) {
      return text.starts_with("sea " + sea + ": its zones pass into each other");
    });
  };
  EXPECT_TRUE(told("two"));   // 60 m, waves of some 100 m
  EXPECT_FALSE(told("one"));  // 150 m
}

TEST(Zones, MustCoverThePlateBeforeAnythingIsSolved) {
  Case data = zonal_run().data;
  data.seas[2].zones->bounds[0].x_from = -60.0;
  EXPECT_THROW(test::run(data), DataError);
}

}  // namespace
}  // namespace floe
