#include "case_refusal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace floe::io {
namespace {

using test::read_with;
using test::refusal;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kSea = R"([[sea]]
name = "design"
spectrum = "bretschneider"
significant_height = 2.0
significant_period = 6.3
spreading = "cos2"
mean_heading_deg = [0, 30]
)";

// kSea with `from` replaced by `to`
std::string changed(const std::string& from, const std::string& to) {
  return test::replaced(kSea, from, to);
}

TEST(CaseSeas, TakesOverEverySpectrumAndSpreading) {
  const Case data = read_with(kSea + R"([[sea]]
name = "tail"
spectrum = "jonswap"
significant_height = 3
peak_period = 9
gamma = 2
spreading = "cos2s"
s = 10
mean_heading_deg = [-90]
duration = 3600
allow_truncation = true
[[sea]]
name = "pm"
spectrum = "pierson-moskowitz"
significant_height = 3
peak_period = 9
spreading = "cosn"
n = 4
mean_heading_deg = [0]
[[sea]]
name = "measured"
spectrum = "table"
omega = [0.5, 0.7, 1.0]
density = [0, 1.5, 0]
spreading = "wrapped-normal"
std_deg = 15
mean_heading_deg = [0, 0]
[[sea]]
name = "long"
spectrum = "jonswap"
significant_height = 1
peak_period = 9
spreading = "none"
mean_heading_deg = [0]
)");
  ASSERT_EQ(data.seas.size(), 5u);
  EXPECT_EQ(data.seas[0].name, "design");
  EXPECT_THAT(data.seas[0].mean_heading_deg, ElementsAre(0.0, 30.0));
  EXPECT_EQ(data.seas[0].duration, 10800.0);
  EXPECT_FALSE(data.seas[0].allow_truncation);
  // Hs² / 16 but for Bretschneider-Mitsuyasu, whose height is that of the highest third
  EXPECT_NEAR(data.seas[0].m0(), 0.257 * 4.0 / 4.12, 1e-12);
  EXPECT_NEAR(data.seas[1].m0(), 9.0 / 16.0, 1e-9);
  EXPECT_NEAR(data.seas[2].m0(), 9.0 / 16.0, 1e-9);
  EXPECT_NEAR(data.seas[3].m0(), 0.5 * 1.5 * 0.5, 1e-12);
  EXPECT_EQ(data.seas[1].duration, 3600.0);
  EXPECT_TRUE(data.seas[1].allow_truncation);
  EXPECT_THAT(data.seas[3].mean_heading_deg, ElementsAre(0.0));
  EXPECT_TRUE(data.seas[4].partitions[0].spreading.long_crested());
  EXPECT_EQ(
      data.seas[1].description,
      "jonswap (significant_height = 3 m, peak_period = 9 s, gamma = 2), spreading cos2s s = 10");
}

TEST(CaseSeas, PartitionsTurnAgainstTheFirst) {
  const Case data = read_with(R"([[sea]]
name = "both"
[[sea.partition]]
spectrum = "jonswap"
significant_height = 2
peak_period = 7
spreading = "cos2"
mean_heading_deg = 20
[[sea.partition]]
spectrum = "jonswap"
significant_height = 1
peak_period = 12
spreading = "none"
mean_heading_deg = 330
)");
  ASSERT_EQ(data.seas.size(), 1u);
  EXPECT_THAT(data.seas[0].mean_heading_deg, ElementsAre(20.0));
  ASSERT_EQ(data.seas[0].partitions.size(), 2u);
  EXPECT_EQ(data.seas[0].partitions[1].turn_deg, 310.0);
  EXPECT_NEAR(data.seas[0].m0(), (4.0 + 1.0) / 16.0, 1e-9);
}

TEST(CaseSeas, NameTheFaultAndItsPlace) {
  const std::pair<std::string, const char*> table[] = {
      {changed("height = 2.0", "height = -2.0"),
       "case.toml:16:22: invalid sea[0].significant_height = -2 m (must be positive)"},
      {changed("period = 6.3", "period = 0"),
       "case.toml:17:22: invalid sea[0].significant_period = 0 s (must be 0.1 to 1000)"},
      {changed("\"bretschneider\"", "\"jonswop\""),
       "case.toml:15:12: invalid sea[0].spectrum = \"jonswop\" (did you mean jonswap?)"},
      {changed("\"cos2\"", "\"fan\""),
       "case.toml:18:13: invalid sea[0].spreading = \"fan\" (must be"},
      {changed("spreading = \"cos2\"\n", ""), "missing sea[0].spreading (required: must be one of"},
      {changed("mean_heading_deg = [0, 30]\n", ""), "missing sea[0].mean_heading_deg (must be"},
      {changed("significant_period", "peak_period"),
       "unused sea[0].peak_period (a spectrum = \"bretschneider\" takes significant_height, "
       "significant_period)"},
      {changed("name = \"design\"\n", ""), "missing sea[0].name (required: a name"},
      {changed("\"design\"", "\"=cmd()\""), "invalid sea[0].name = \"=cmd()\" (must be 1 to 64"},
      {changed("spreading", "spreding"), "unknown key sea[0].spreding (did you mean"},
      {kSea + kSea, "case.toml:21:8: invalid sea[1].name = \"design\" (must differ"},
      {changed("\"bretschneider\"", "\"jonswap\"\ngamma = 30").replace(0, 0, ""),
       "unused sea[0].significant_period"},
      {changed("cos2\"", "cos2s\"\ns = 0"), "invalid sea[0].s = 0 (must be 0.5 to 1000)"},
      {"[[sea]]\nname = \"t\"\nspectrum = \"table\"\nomega = [1, 0.5]\ndensity = [1, 1]\n"
       "spreading = \"none\"\nmean_heading_deg = [0]\n",
       "case.toml:16:13: invalid sea[0].omega[1] = 0.5 rad/s (must be greater than the one "
       "before)"},
      {"[[sea]]\nname = \"t\"\nspectrum = \"table\"\nomega = [1, 2]\ndensity = [1, -1]\n"
       "spreading = \"none\"\nmean_heading_deg = [0]\n",
       "case.toml:17:15: invalid sea[0].density[1] = -1 m² s/rad (must be at least 0)"},
      {"[[sea]]\nname = \"t\"\nspectrum = \"table\"\nomega = [1, 2]\ndensity = [1]\n"
       "spreading = \"none\"\nmean_heading_deg = [0]\n",
       "invalid sea[0].density = a list of 1 (must be as long as omega, 2, and 2 or more)"},
  };
  for (const auto& [text, message] : table) EXPECT_THAT(refusal(text), HasSubstr(message)) << text;
}

const std::string kOutput = R"([output]
points = { A = [0, 0], B = [10, 0] }
quantities = ["deflection", "surface_stress_x", "surface_stress_y", "twisting_moment"]
)";

TEST(CaseRelations, AreReadByTheNamesOfPointsAndQuantities) {
  const Case data =
      read_with(kOutput + R"(cross_spectra = [["A", "deflection", "B", "twisting_moment"]]
combinations = { step = { terms = [["B", "deflection", 1], ["A", "deflection", -1.5]] }, stress = { von_mises = "B" } }
)");
  ASSERT_EQ(data.relations.pairs.size(), 1u);
  EXPECT_EQ(data.relations.pairs[0].first.point, 0u);
  EXPECT_EQ(data.relations.pairs[0].second.point, 1u);
  EXPECT_EQ(data.relations.pairs[0].second.quantity, 3u);
  ASSERT_EQ(data.relations.combinations.size(), 2u);
  const Combination& step = data.relations.combinations[0];
  EXPECT_EQ(step.name, "step");
  EXPECT_EQ(step.kind, Combination::Kind::kSum);
  EXPECT_EQ(step.terms.at(1).factor, -1.5);
  const Combination& stress = data.relations.combinations[1];
  EXPECT_EQ(stress.kind, Combination::Kind::kVonMises);
  ASSERT_EQ(stress.terms.size(), 3u);
  EXPECT_EQ(stress.terms[2].of.quantity, 3u);
  EXPECT_DOUBLE_EQ(stress.terms[2].factor, 6.0 / 4.0);  // 6 / t², t = 2 m
}

// What a fault says: these are faults of the case, exit code 3
std::string relation_refusal(const std::string& line) {
  try {
    read_with(kOutput + line + "\n");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CaseRelations, RefuseWhatIsNotThere) {
  EXPECT_THAT(relation_refusal(R"(cross_spectra = [["A", "deflection", "B", "deflectoin"]])"),
              HasSubstr("did you mean deflection?"));
  EXPECT_THAT(
      relation_refusal(R"(cross_spectra = [["elsewhere", "deflection", "B", "deflection"]])"),
      HasSubstr("must be one of output.points"));
  EXPECT_THAT(relation_refusal(R"(cross_spectra = [["A", "deflection"]])"),
              HasSubstr("must be lists"));
  EXPECT_THAT(relation_refusal(R"(cross_spectra = [["A", "pressure", "B", "deflection"]])"),
              HasSubstr("must be one of output.quantities"));
  EXPECT_THAT(relation_refusal(R"(combinations = { x = {} })"), HasSubstr("exactly one of"));
  EXPECT_THAT(relation_refusal(R"(combinations = { x = { terms = [] } })"),
              HasSubstr("must hold a term"));
  EXPECT_THAT(relation_refusal(R"(combinations = { x = { terms = [["A", "deflection", 0]] } })"),
              HasSubstr("must be finite and not 0"));
}

}  // namespace
}  // namespace floe::io
