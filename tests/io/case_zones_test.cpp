#include "case_refusal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace floe::io {
namespace {

using test::kCaseText;
using test::refusal;
using test::TestFolder;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kZones = R"([[sea]]
name = "island"
transition = 120.0
coherence = 0.4
spreading = "cos2"
mean_heading_deg = [0, 30]
[[sea.zone]]
x = [-200, 0]
spectrum = "jonswap"
significant_height = 1.0
peak_period = 7.0
[[sea.zone]]
x = [0, 200]
y = [-40, 40]
spectrum = "bretschneider"
significant_height = 2.0
significant_period = 7.0
)";

std::string changed(const std::string& from, const std::string& to) {
  return test::replaced(kZones, from, to);
}

TEST(CaseZones, AreTakenOver) {
  const TestFolder folder;
  const Case data = read_case(folder.write("case.toml", kCaseText + kZones)).data;
  ASSERT_EQ(data.seas.size(), 1u);
  const wave::SeaState& sea = data.seas[0];
  ASSERT_TRUE(sea.zones);
  EXPECT_THAT(sea.mean_heading_deg, ElementsAre(0.0, 30.0));
  EXPECT_EQ(sea.zones->transition, 120.0);
  EXPECT_EQ(sea.zones->coherence, wave::uniform_coherence(2, 0.4));
  ASSERT_EQ(sea.zones->bounds.size(), 2u);
  EXPECT_EQ(sea.zones->bounds[0].x_from, -200.0);
  EXPECT_TRUE(std::isinf(sea.zones->bounds[0].y_to));
  EXPECT_EQ(sea.zones->bounds[1].y_to, 40.0);
  // Told by their mean
  EXPECT_NEAR(sea.m0(), 0.5 * (1.0 / 16.0 + 0.257 * 4.0 / 4.12), 1e-9);
  EXPECT_THAT(sea.description, HasSubstr("transition 120 m, coherence [0.4], spreading cos2"));

  const Case matrix =
      read_case(
          folder.write("case.toml", kCaseText + changed("0.4", "[\n  [1, 0.7],\n  [0.7, 1]]")))
          .data;
  EXPECT_EQ(matrix.seas[0].zones->coherence(1, 0), 0.7);
}

TEST(CaseZones, NameTheFaultAndItsPlace) {
  const std::pair<std::string, const char*> table[] = {
      {changed("coherence = 0.4\n", ""), "missing sea[0].coherence (required: 0 to 1 between any"},
      {changed("transition = 120.0\n", ""), "missing sea[0].transition (required: a number in m"},
      {changed("= 120.0", "= 0"), "case.toml:15:14: invalid sea[0].transition = 0 m (must be pos"},
      {changed("0.4", "1.5"), "invalid sea[0].coherence = 1.5 (must be 0 to 1)"},
      {changed("0.4", "[0.4]"), "invalid sea[0].coherence (must be 2 lists of 2 numbers)"},
      {changed("0.4", "[[1, 0.4], [0.5, 1]]"), "sea[0].coherence (invalid coherence (must be symm"},
      {changed("[-200, 0]", "[0, -200]"), "invalid sea[0].zone[0].x = [0, -200] m (must be from l"},
      {changed("[-200, 0]", "3"), "invalid sea[0].zone[0].x = 3 (must be [from, to] in m)"},
      {changed("\"jonswap\"", "\"measured\""),
       "invalid sea[0].zone[0].spectrum = \"measured\" (mu"},
      {changed("spreading = \"cos2\"\n", ""), "missing sea[0].spreading (required"},
      {changed("[[sea.zone]]\nx", "gamma = 2\n[[sea.zone]]\nx"),
       "unused sea[0].gamma (a sea with zones gives it in each)"},
      {changed("x = [-200, 0]\n", "z = [1, 2]\n"),
       "unknown key sea[0].zone[0].z (did you mean sea[0].zone[0].x?)"},
      {"[[sea]]\nname = \"a\"\nspectrum = \"jonswap\"\nsignificant_height = 1\npeak_period = 9\n"
       "spreading = \"none\"\nmean_heading_deg = [0]\ncoherence = 1\n",
       "case.toml:20:13: unused sea[0].coherence (it belongs to [[sea.zone]])"},
  };
  for (const auto& [text, message] : table) EXPECT_THAT(refusal(text), HasSubstr(message)) << text;
}

TEST(CaseZones, NeedARunOfTheirOwn) {
  const TestFolder folder;
  try {
    read_sea_file(folder.write("sea.toml", kZones));
    FAIL() << "accepted";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("sea.toml: sea island has zones (must stand in the case"));
  }
}

}  // namespace
}  // namespace floe::io
