#include "io/netcdf_file.hpp"
#include "test_case.hpp"

#include <floe/analysis.hpp>
#include <floe/io/directory_store.hpp>
#include <floe/io/stored_run.hpp>
#include <floe/response/pseudo_excitation.hpp>

#include <gtest/gtest.h>
#include <recorded_run.hpp>

#include <cmath>

namespace floe::io {
namespace {

TEST(identity_NodeSpectra, IntegrateToTheVariancesOfTheNodes) {
  Case data = test::table1_case(8, 2);
  data.mode_count = 6;
  data.omega = {0.4};
  data.heading_deg = {0.0};
  data.allow_coarse = true;
  data.sea_grid = {.from = 0.35, .to = 0.45, .tolerance = 1e-2};
  data.node_spectra = true;
  data.seas = {{.name = "swell",
                .description = "",
                .partitions = {{wave::Spectrum::bretschneider(2.0, 15.0),
                                wave::Spreading::cosine_power(2.0)}},
                .mean_heading_deg = {0.0, 30.0},
                .allow_truncation = true}};
  const test::TestFolder folder;
  const auto path = folder.path() / "run.out";
  test::RecordedRun unused;
  test::RecordingLog log(unused);
  DirectoryStore store(path);
  analyse(data, log, store);

  const NetcdfFile file = NetcdfFile::open(path / "node_spectra.nc");
  const std::vector<double> omega = file.numbers("omega"),
                            weight = response::trapezoid_weights(omega);
  const std::vector<double> spectrum = file.numbers("spectrum");
  EXPECT_EQ(file.texts("sea_name"), (std::vector<std::string>{"swell", "swell"}));
  EXPECT_EQ(file.numbers("mean_heading_deg"), (std::vector<double>{0.0, 30.0}));
  const std::vector<SeaResult> seas = StoredRun(path).seas();
  const std::size_t nodes = file.numbers("x").size();
  ASSERT_EQ(spectrum.size(), seas.size() * omega.size() * nodes);
  for (std::size_t s = 0; s < seas.size(); ++s)
    for (std::size_t n = 0; n < nodes; ++n) {
      double variance = 0.0;
      for (std::size_t i = 0; i < omega.size(); ++i)
        variance += weight[i] * spectrum[(s * omega.size() + i) * nodes + n];
      const double expected = seas[s].node_moments(static_cast<Index>(n), 0);
      EXPECT_NEAR(variance, expected, 1e-10 * expected) << s << " " << n;
    }
}

}  // namespace
}  // namespace floe::io
