#include <floe/analysis.hpp>
#include <floe/long_term_statistics.hpp>
#include <floe/sea_statistics.hpp>

#include <expect.hpp>
#include <gtest/gtest.h>
#include <recorded_run.hpp>

#include <algorithm>
#include <cmath>

namespace floe {
namespace {

using response::Quantity;

// A band of few solves on a coarse mesh, with everything that statistics tell
const test::RecordedRun& small_run() {
  static const test::RecordedRun run = [] {
    Case data = test::table1_case(24, 6);
    data.mode_count = 12;
    data.plate.loss_factor = 0.05;
    data.omega = {0.5};
    data.heading_deg = {0.0, 30.0, 105.0};
    data.quantities = {Quantity::kDeflection,     Quantity::kAcceleration, Quantity::kSlopeX,
                       Quantity::kBendingMomentX, Quantity::kShearForceX,  Quantity::kPressure,
                       Quantity::kSurfaceStressX};
    data.sea_grid = {.from = 0.5, .to = 0.9, .tolerance = 1e-3};
    data.seas = {
        {.name = "wind sea",
         .description = "",
         .partitions = {{wave::Spectrum::bretschneider(2.0, 8.5),
                         wave::Spreading::cosine_power(2.0)}},
         .mean_heading_deg = {0.0, 40.0},
         .allow_truncation = true},
        {.name = "long crests",
         .description = "",
         .partitions = {{wave::Spectrum::bretschneider(2.0, 8.5), wave::Spreading::none()}},
         .mean_heading_deg = {30.0},
         .allow_truncation = true}};
    return test::run(data);
  }();
  return run;
}

TEST(twin_Seas, TransferFunctionsAreTheRaosOfTheSameWave) {
  // The lowest frequency of the band is solved by itself in both stages; what the sea's stage does
  // by reciprocity, the other does by a diffraction problem: they differ by the discretisation
  const test::RecordedRun& run = small_run();
  const SeaTransfer& transfer = run.transfers.front();
  ASSERT_EQ(transfer.omega, 0.5);
  const Index points = static_cast<Index>(run.data.points.size());
  const double circle = static_cast<double>(transfer.state.cols());
  const MatXcd seen = run.observation.points.cast<Complex>() * transfer.state;
  for (std::size_t k = 0; k < run.observation.quantity.size(); ++k) {
    const std::size_t q = run.observation.quantity[k];
    const MatXd rao = run.frequencies[0].point_quantities[q].cwiseAbs();
    const double factor = std::pow(0.5, run.observation.derivative[k]);
    for (Index h = 0; h < rao.cols(); ++h) {
      const double degrees = run.data.heading_deg[static_cast<std::size_t>(h)];
      const auto column = static_cast<Index>(std::lround(degrees / 360.0 * circle));
      const VecXd own =
          factor * seen.col(column).segment(static_cast<Index>(k) * points, points).cwiseAbs();
      EXPECT_LE((own - rao.col(h)).cwiseAbs().maxCoeff(), 1e-2 * rao.maxCoeff())
          << response::name(run.data.quantities[q]) << " at " << degrees << "°";
    }
  }
}

TEST(twin_Seas, LongCrestsHaveTheSpectrumTimesTheSquaredRao) {
  const test::RecordedRun& run = small_run();
  const SeaResult& sea = run.seas.at(2);
  ASSERT_EQ(sea.sea, "long crests");
  const VecXcd rao = run.frequencies[0].point_deflection.col(1);
  const double density = run.data.seas[1].density(0.5);
  EXPECT_LE(test::relative_error(sea.spectra[0].col(0), density * rao.cwiseAbs2()), 5e-3);
}

TEST(identity_Seas, MeanHeadingsBetweenTheDirectionsAreInterpolatedExactly) {
  // 40° is none of the circle's headings; on a circle with three times as many headings it is one.
  // What differs is the sum over directions, of third order in 7.5° at the ends of the lobe
  const test::RecordedRun& run = small_run();
  const auto circle = static_cast<int>(run.transfers.front().state.cols());
  ASSERT_NE(std::fmod(40.0 * circle / 360.0, 1.0), 0.0);
  std::vector<double> omega, finer;
  for (int i = 0; i < 3 * circle; ++i) finer.push_back(2.0 * M_PI * i / (3 * circle));
  for (const SeaTransfer& transfer : run.transfers) omega.push_back(transfer.omega);
  SeaStatistics statistics(run.data.seas, run.observation, omega, 3 * circle);
  const response::CircleInterpolation interpolate(finer, circle);
  for (const SeaTransfer& transfer : run.transfers)
    statistics.add({transfer.omega, interpolate(transfer.state)});
  const std::vector<SeaResult> fine = statistics.results();
  for (std::size_t s = 0; s < fine.size(); ++s)
    for (std::size_t q = 0; q < fine[s].moments.size(); ++q)
      EXPECT_LE(test::relative_error(run.seas[s].moments[q], fine[s].moments[q]), 1e-4) << s << q;
}

TEST(identity_Seas, NodesLinesAndPointsTellTheSameDeviation) {
  const test::RecordedRun& run = small_run();
  for (const SeaResult& sea : run.seas) {
    // P5 is a node of the mesh: its deflection is one of the nodes'
    const double own = sea.moments[0](4, 0);
    EXPECT_LE((sea.node_moments.col(0).array() - own).abs().minCoeff(), 1e-10 * own);
    EXPECT_GT(sea.share_outside, 0.0);
    EXPECT_LT(sea.grid_error, 1e-2);
  }
  EXPECT_LT(static_cast<std::size_t>(run.sea_grid.solved_frequencies), run.transfers.size() / 2);
  EXPECT_LE(run.sea_grid.interpolation_error, 1e-3);
}

TEST(identity_Seas, PartitionsAddUp) {
  const test::RecordedRun& run = small_run();
  wave::SeaState both = run.data.seas[0];
  both.mean_heading_deg = {0.0};
  both.partitions.push_back(
      {wave::Spectrum::bretschneider(2.0, 8.5), wave::Spreading::none(), 30.0});
  std::vector<double> omega;
  for (const SeaTransfer& transfer : run.transfers) omega.push_back(transfer.omega);
  SeaStatistics statistics({both}, run.observation, omega,
                           static_cast<int>(run.transfers.front().state.cols()));
  for (const SeaTransfer& transfer : run.transfers) statistics.add(transfer);
  const SeaResult sum = statistics.results().front();
  EXPECT_LE(test::relative_error(sum.moments[3], run.seas[0].moments[3] + run.seas[2].moments[3]),
            1e-12);
}

TEST(twin_Seas, AMeasuredTableOfASpectrumIsThatSpectrum) {
  // Straight lines of 2° and 0.002 rad/s are off by at most h²/8 of the second derivatives: cos²ˢ
  // with s = 8 has D''/D ≤ 4 in its width (6e-4), S of a peak of 0.07 ωp has 1/(0.07 ωp)² (2e-4)
  const test::RecordedRun& run = small_run();
  const wave::Spectrum spectrum = wave::Spectrum::jonswap(2.0, 9.0, 2.0);
  const wave::Spreading spreading = wave::Spreading::half_angle_cosine(8.0);
  const double degree = M_PI / 180.0;
  std::vector<double> omega, heading;
  for (int i = 0; i <= 300; ++i) omega.push_back(0.45 + 0.002 * i);
  for (int j = 0; j < 180; ++j) heading.push_back(2.0 * degree * j);
  MatXd density(301, 180);
  for (Index i = 0; i < 301; ++i)
    for (Index j = 0; j < 180; ++j)
      density(i, j) = spectrum(omega[static_cast<std::size_t>(i)]) *
                      spreading(heading[static_cast<std::size_t>(j)] - 40.0 * degree);
  const wave::DirectionalSpectrum table(omega, heading, density);
  EXPECT_NEAR(table.mean_heading(), 40.0 * degree, 1e-9);

  wave::SeaState formula = run.data.seas[0], measured = run.data.seas[0];
  formula.mean_heading_deg = measured.mean_heading_deg = {40.0};
  formula.partitions = {{spectrum, spreading}};
  measured.partitions = {{table.over_directions(), wave::Spreading::none(), 0.0, table}};
  std::vector<double> frequencies;
  for (const SeaTransfer& transfer : run.transfers) frequencies.push_back(transfer.omega);
  SeaStatistics statistics({formula, measured}, run.observation, frequencies,
                           static_cast<int>(run.transfers.front().state.cols()));
  for (const SeaTransfer& transfer : run.transfers) statistics.add(transfer);
  const std::vector<SeaResult> results = statistics.results();
  for (std::size_t q = 0; q < results[0].moments.size(); ++q)
    EXPECT_LE(test::relative_error(results[1].moments[q], results[0].moments[q]), 1e-3) << q;
  EXPECT_NEAR(results[1].band_height, results[0].band_height, 1e-3 * results[0].band_height);
}

TEST(identity_Seas, TellWhatTheirSumsMakeOfThem) {
  for (const SeaResult& sea : small_run().seas) {
    EXPECT_NEAR(sea.spreading_sum, 1.0, 1e-6);
    // What the frequencies sum up is what is not outside of them
    EXPECT_NEAR(sea.band_height, sea.significant_height * std::sqrt(1.0 - sea.share_outside),
                1e-3 * sea.significant_height);
  }
}

TEST(twin_LongTerm, AClassHasTheMomentsOfItsSea) {
  const test::RecordedRun& run = small_run();
  std::vector<double> omega;
  for (const SeaTransfer& transfer : run.transfers) omega.push_back(transfer.omega);
  const auto circle = static_cast<int>(run.transfers.front().state.cols());

  // Two headings, one between the circle's, and two periods; the class of 3 m and 11 s as a sea
  wave::WaveClimate climate;
  climate.name = "climate";
  climate.gamma = 2.0;
  climate.spreading = wave::Spreading::half_angle_cosine(8.0);
  climate.mean_heading_deg = {0.0, 40.0};
  climate.heading_probability = {0.25, 0.75};
  climate.scatter = wave::scatter_diagram({1.0, 3.0}, {9.0, 11.0}, wave::PeriodType::kPeak,
                                          (MatXd(2, 2) << 5, 3, 0, 2).finished());
  const wave::SeaState sea{
      .name = "class",
      .description = "",
      .partitions = {{wave::Spectrum::jonswap(3.0, 11.0, 2.0), climate.spreading}},
      .mean_heading_deg = {40.0},
      .allow_truncation = true};
  LongTermStatistics many_years({climate}, run.observation, omega, circle);
  SeaStatistics statistics({sea}, run.observation, omega, circle);
  for (const SeaTransfer& transfer : run.transfers) {
    many_years.add(transfer);
    statistics.add(transfer);
  }
  const LongTermResult result = many_years.results().front();
  const SeaResult expected = statistics.results().front();
  for (std::size_t q = 0; q < expected.quantity.size(); ++q) {
    EXPECT_LE(test::relative_error(9.0 * result.m0[q].col(3), expected.moments[q].col(0)), 1e-12);
    EXPECT_LE(test::relative_error(9.0 * result.m2[q].col(3), expected.moments[q].col(2)), 1e-12);
  }
  EXPECT_NEAR(result.share_outside[1], expected.share_outside, 1e-10);

  // The rate of peaks beyond a level, over classes and headings by hand (E.21)
  const double level = 0.2;
  double rate = 0.0;
  for (Index h = 0; h < 2; ++h)
    for (Index i = 0; i < 2; ++i)
      for (Index j = 0; j < 2; ++j) {
        const double height = i == 0 ? 1.0 : 3.0, share = h == 0 ? 0.25 : 0.75;
        const double m0 = height * height * result.m0[0](4, 2 * h + j);
        const double m2 = height * height * result.m2[0](4, 2 * h + j);
        rate += share * climate.scatter.probability(i, j) * std::sqrt(m2 / m0) / (2.0 * M_PI) *
                std::exp(-0.5 * level * level / m0);
      }
  const response::LongTermDistribution distribution = result.distribution(0, 4);
  EXPECT_NEAR(distribution.exceedance(level) * distribution.peak_rate() / rate, 1.0, 1e-12);
  EXPECT_EQ(result.worst_class(0, 4, distribution.return_value(3e9)).height, 3.0);
}

TEST(Seas, TellWhatIsLeftOut) {
  const auto& notices = small_run().notices;
  EXPECT_TRUE(std::any_of(notices.begin(), notices.end(), [](const std::string& text) {
    return text.find("pressure") != std::string::npos;
  }));
}

}  // namespace
}  // namespace floe
