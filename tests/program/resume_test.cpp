#include "floe_program.hpp"
#include "stored_products.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>

// Runs that are stopped in any way and gone on with.
namespace floe {
namespace {

using test::expect_same_products;
using test::kCaseText;
using test::ProgramResult;
using test::run_floe;
using test::TestFolder;
using test::with;
using testing::HasSubstr;
using testing::Not;

const std::string kRest = R"([modes]
count = 8
[sea_grid]
omega = { from = 0.4, to = 0.8 }
[[sea]]
name = "design"
spectrum = "bretschneider"
significant_height = 2.0
significant_period = 10.0
spreading = "cos2"
mean_heading_deg = [0]
allow_truncation = true
[output]
points = { P1 = [-150, -30], P5 = [0, 0] }
quantities = ["deflection", "bending_moment_x"]
)";

std::string sweep(int count) {
  return with("[0.4, 0.5]", "{ from = 0.2, to = 0.6, count = " + std::to_string(count) + " }") +
         kRest;
}

// Seconds that the stages of solving took
double solving_seconds(const TestFolder& folder, const std::string& name) {
  double seconds = 0.0;
  const auto run = nlohmann::json::parse(folder.read(name + "/run.json"));
  for (const auto& stage : run.at("stages"))
    if (stage.at("stage") != "mesh" && stage.at("stage") != "dry modes")
      seconds += stage.at("seconds").get<double>();
  return seconds;
}

TEST(Resume, AfterAKillAtAnyInstantGivesTheSameBytes) {
  const TestFolder folder;
  folder.write("case.toml", sweep(20));
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o whole").code, 0);
  std::mt19937 random(11);
  std::uniform_int_distribution<int> milliseconds(20, 500);
  int killed = 0;
  for (int trial = 0; killed < 20 && trial < 60; ++trial) {
    std::filesystem::remove_all(folder.path() / "parts");
    for (int attempt = 0; attempt < 100; ++attempt) {
      const std::string limit = "0." + std::to_string(1000 + milliseconds(random)).substr(1);
      const ProgramResult result =
          attempt < 2 ? run_floe(folder, "run case.toml --allow-coarse -o parts --resume",
                                 "timeout -s KILL " + limit)
                      : run_floe(folder, "run case.toml --allow-coarse -o parts --resume");
      if (result.code == 0) break;
      ASSERT_EQ(result.code, 137) << result.error;
      ++killed;
    }
    expect_same_products(folder, "whole", "parts");
  }
  EXPECT_GE(killed, 20);
}

TEST(Resume, GoesOnAfterMaxTime) {
  const TestFolder folder;
  folder.write("case.toml", sweep(400));
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o whole").code, 0);
  const std::string run = "run case.toml --allow-coarse -o parts --resume";
  const ProgramResult first = run_floe(folder, run + " --max-time 0.3s");
  EXPECT_EQ(first.code, 75) << first.error;
  EXPECT_THAT(first.error, HasSubstr("stopped by --max-time (give --resume to go on)"));
  const auto account = nlohmann::json::parse(folder.read("parts/run.json"));
  EXPECT_THAT(account.at("status").get<std::string>(), HasSubstr("stopped by --max-time"));
  EXPECT_EQ(run_floe(folder, run).code, 0);
  expect_same_products(folder, "whole", "parts");
}

TEST(Resume, OfAFinishedRunSolvesNothing) {
  const TestFolder folder;
  folder.write("case.toml", sweep(3));
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o whole").code, 0);
  std::filesystem::copy(folder.path() / "whole", folder.path() / "again",
                        std::filesystem::copy_options::recursive);
  std::filesystem::remove(folder.path() / "again/rao_points.csv");
  const ProgramResult result = run_floe(folder, "run case.toml --allow-coarse -o again --resume");
  ASSERT_EQ(result.code, 0) << result.error;
  expect_same_products(folder, "whole", "again");
  EXPECT_GT(solving_seconds(folder, "whole"), 0.0);
  EXPECT_EQ(solving_seconds(folder, "again"), 0.0);
}

TEST(Resume, ComputesADamagedRecordAgainAndSaysSo) {
  const TestFolder folder;
  folder.write("case.toml", sweep(3));
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o whole").code, 0);
  for (const char* name : {"frequency_00002", "transfer_00005", "modes", "sea_grid"}) {
    std::filesystem::remove_all(folder.path() / "again");
    std::filesystem::copy(folder.path() / "whole", folder.path() / "again",
                          std::filesystem::copy_options::recursive);
    const std::string path = std::string("again/records/") + name + ".rec";
    std::string record = folder.read(path);
    record[record.size() / 2] ^= 4;
    folder.write(path, record);
    const ProgramResult result = run_floe(folder, "run case.toml --allow-coarse -o again --resume");
    ASSERT_EQ(result.code, 0) << result.error;
    EXPECT_THAT(result.output,
                HasSubstr(std::string(name) + ".rec is damaged (moved to records/bad/" + name +
                          ".rec), computed again"));
    expect_same_products(folder, "whole", "again");
    // And is good now
    EXPECT_THAT(run_floe(folder, "run case.toml --allow-coarse -o again --resume").output,
                Not(HasSubstr("damaged")));
  }
}

TEST(Resume, RefusesTheResultsOfAnotherCase) {
  const TestFolder folder;
  folder.write("case.toml", sweep(3));
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse").code, 0);
  folder.write("case.toml", "title = \"only a title\"\n" + sweep(3));
  EXPECT_EQ(run_floe(folder, "run case.toml --allow-coarse --resume").code, 0);
  std::string other = sweep(3);
  other.replace(other.find("thickness = 2.0"), 15, "thickness = 2.5");
  folder.write("case.toml", other);
  const ProgramResult result = run_floe(folder, "run case.toml --allow-coarse --resume");
  EXPECT_EQ(result.code, 9);
  EXPECT_THAT(result.error, HasSubstr("holds results of another case: /options/plate/thickness"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "case.out/rao_points.csv"));
  EXPECT_EQ(run_floe(folder, "run case.toml --allow-coarse --resume --fresh").code, 2);
}

TEST(Resume, StartsWhereThereIsNothing) {
  const TestFolder folder;
  folder.write("case.toml", sweep(2));
  const ProgramResult result = run_floe(folder, "run case.toml --allow-coarse --resume");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_THAT(result.output, Not(HasSubstr("damaged")));
}

}  // namespace
}  // namespace floe
