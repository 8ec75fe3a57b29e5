#include "floe_program.hpp"
#include "stored_products.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

// What floe status and floe export tell and make of runs in any state.
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
count = 6
[sea_grid]
omega = { from = 0.4, to = 0.6 }
[[sea]]
name = "design"
spectrum = "bretschneider"
significant_height = 2.0
significant_period = 12.0
spreading = "cos2"
mean_heading_deg = [0]
allow_truncation = true
[output]
points = { P1 = [-150, -30] }
)";

nlohmann::json status_of(const TestFolder& folder, const std::string& run) {
  const ProgramResult result = run_floe(folder, "status --json " + run);
  EXPECT_EQ(result.code, 0) << result.error;
  return nlohmann::json::parse(result.output);
}

TEST(Status, TellsWhatIsDoneDamagedAndOpen) {
  const TestFolder folder;
  folder.write("case.toml", "title = \"raft\"\n" + kCaseText + kRest);
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse").code, 0);
  const nlohmann::json whole = status_of(folder, "case.out");
  EXPECT_EQ(whole.at("status"), "complete");
  EXPECT_EQ(whole.at("done"), 2);
  EXPECT_EQ(whole.at("total"), 2);
  EXPECT_EQ(whole.at("seconds_left"), 0.0);
  EXPECT_EQ(whole.at("running"), false);
  EXPECT_EQ(whole.at("seas").at("done"), true);
  EXPECT_LT(whole.at("frequencies").at(1).at("true_residual").get<double>(), 1e-6);
  EXPECT_THAT(run_floe(folder, "status case.out").output,
              testing::AllOf(HasSubstr("case.out · raft"), HasSubstr("state      complete"),
                             HasSubstr("done       2 of 2 frequencies"), Not(HasSubstr("left"))));

  std::filesystem::remove(folder.path() / "case.out/records/sea_grid.rec");
  std::filesystem::remove(folder.path() / "case.out/records/frequency_00001.rec");
  folder.write("case.out/records/frequency_00002.rec", "rubbish");
  const nlohmann::json broken = status_of(folder, "case.out");
  EXPECT_EQ(broken.at("complete"), false);
  EXPECT_EQ(broken.at("done"), 0);
  EXPECT_EQ(broken.at("frequencies").at(0).at("state"), "open");
  EXPECT_EQ(broken.at("frequencies").at(1).at("state"), "damaged");
  EXPECT_EQ(broken.at("seas").at("done"), false);
  EXPECT_GT(broken.at("seas").at("transfer_functions_done").get<int>(), 10);
  EXPECT_GT(broken.at("seconds_left").get<double>(), 0.0);
  EXPECT_THAT(run_floe(folder, "status case.out").output, HasSubstr("left       about "));
  EXPECT_EQ(run_floe(folder, "status .").code, 9);
  EXPECT_EQ(run_floe(folder, "status none").code, 9);
}

TEST(Status, TellsARunningRunFromAKilledOne) {
  const TestFolder folder;
  folder.write("case.toml", with("[0.4, 0.5]", "{ from = 0.2, to = 0.6, count = 20000 }"));
  // The status is asked for while the run works, which then is killed
  const ProgramResult asked =
      run_floe(folder,
               "run case.toml --allow-coarse --progress=none & "
               "while [ ! -e case.out/records/frequency_00003.rec ]; do :; done; '" FLOE_PROGRAM
               "' status --json case.out >while; kill -KILL $!; wait $! 2>/dev/null; true");
  ASSERT_EQ(asked.code, 0) << asked.error;
  const auto running = nlohmann::json::parse(folder.read("while"));
  EXPECT_EQ(running.at("running"), true);
  EXPECT_THAT(running.at("holder").get<std::string>(), HasSubstr("process "));
  EXPECT_GE(running.at("done").get<int>(), 3);
  EXPECT_EQ(running.at("total"), 20000);
  const nlohmann::json killed = status_of(folder, "case.out");
  EXPECT_EQ(killed.at("running"), false);
  EXPECT_EQ(killed.at("status"), "stopped without notice");
}

TEST(Export, MakesTheProductsOfAFinishedRunAnew) {
  const TestFolder folder;
  folder.write("case.toml", kCaseText + kRest);
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o whole").code, 0);
  std::filesystem::create_directory(folder.path() / "bare");
  std::filesystem::copy(folder.path() / "whole/records", folder.path() / "bare/records");
  const ProgramResult result = run_floe(folder, "export bare");
  ASSERT_EQ(result.code, 0) << result.error;
  expect_same_products(folder, "whole", "bare");
  const auto whole = nlohmann::json::parse(folder.read("whole/run.json"));
  auto bare = nlohmann::json::parse(folder.read("bare/run.json"));
  EXPECT_EQ(bare.at("status"), "complete");
  for (const char* key : {"options", "mesh", "modes", "frequencies", "seas", "warnings"})
    EXPECT_EQ(bare.at(key), whole.at(key)) << key;
  std::vector<std::string> files = whole.at("files"), made = bare.at("files");
  std::sort(made.begin(), made.end());
  // All that is there is listed, and goes with --fresh
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path() / "bare"))
    if (entry.is_regular_file()) {
      EXPECT_TRUE(std::binary_search(
          made.begin(), made.end(),
          std::filesystem::relative(entry.path(), folder.path() / "bare").string()))
          << entry.path();
    }
  EXPECT_EQ(run_floe(folder, "run case.toml --allow-coarse -o bare --fresh").code, 0);
  expect_same_products(folder, "whole", "bare");
}

TEST(Export, OfAKilledRunGivesWhatIsFinished) {
  const TestFolder folder;
  folder.write("case.toml", kCaseText + kRest);
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o out").code, 0);
  std::filesystem::remove(folder.path() / "out/records/frequency_00001.rec");
  std::filesystem::remove(folder.path() / "out/records/sea_grid.rec");
  const ProgramResult result = run_floe(folder, "export out");
  ASSERT_EQ(result.code, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("1 of 2 frequencies are not solved: 0.4 rad/s; nor are the "
                                       "seas (floe run --resume goes on)"));
  const std::string table = folder.read("out/rao_points.csv");
  EXPECT_THAT(table, Not(HasSubstr("\n0.4,")));
  EXPECT_THAT(table, HasSubstr("\n0.5,"));
  // A damaged record is no result
  folder.write("out/records/frequency_00002.rec", "rubbish");
  const ProgramResult damaged = run_floe(folder, "export out");
  EXPECT_EQ(damaged.code, 9);
  EXPECT_THAT(damaged.error, HasSubstr("frequency_00002.rec is not one of floe"));
  EXPECT_EQ(folder.read("out/rao_points.csv"), table);
  EXPECT_EQ(run_floe(folder, "export none").code, 9);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "none"));
}

}  // namespace
}  // namespace floe
