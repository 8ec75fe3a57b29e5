#include "floe_program.hpp"
#include "stored_products.hpp"
#include "sweep_cases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <map>
#include <random>

// Runs that are stopped in any way and gone on with.
namespace floe {
namespace {

using test::expect_same_products;
using test::kDirect;
using test::kModalWithSeas;
using test::ProgramResult;
using test::run_floe;
using test::SweepCase;
using test::TestFolder;
using testing::HasSubstr;
using testing::Not;

// Seconds that the stages of solving took
double solving_seconds(const TestFolder& folder, const std::string& name) {
  double seconds = 0.0;
  const auto run = nlohmann::json::parse(folder.read(name + "/run.json"));
  for (const auto& stage : run.at("stages"))
    if (stage.at("stage") != "mesh" && stage.at("stage") != "dry modes" &&
        stage.at("stage") != "plate")
      seconds += stage.at("seconds").get<double>();
  return seconds;
}

class Resume : public testing::TestWithParam<SweepCase> {};
class ResumeLong : public Resume {};

const auto kName = [](const auto& sweep) { return sweep.param.name; };
INSTANTIATE_TEST_SUITE_P(All, Resume, testing::Values(kModalWithSeas, kDirect), kName);
INSTANTIATE_TEST_SUITE_P(All, ResumeLong, testing::Values(kModalWithSeas, kDirect), kName);

// Twenty kills anywhere in the time that a run takes, each run killed twice before it goes through
TEST_P(Resume, AfterAKillAtAnyInstantGivesTheSameBytes) {
  const TestFolder folder;
  folder.write("case.toml", GetParam().text(6));
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse --threads 1 -o whole").code, 0);
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> instant(0.01, whole.count());
  int killed = 0;
  for (int trial = 0; killed < 20 && trial < 60; ++trial) {
    std::filesystem::remove_all(folder.path() / "parts");
    for (int attempt = 0; attempt < 3; ++attempt) {
      const ProgramResult result =
          run_floe(folder, "run case.toml --allow-coarse --threads 1 -o parts --resume",
                   attempt < 2 ? "timeout -s KILL " + std::to_string(instant(random)) : "");
      if (result.code == 0) break;
      ASSERT_EQ(result.code, 137) << result.error;
      ++killed;
    }
    ASSERT_NO_FATAL_FAILURE(expect_same_products(folder, "whole", "parts")) << killed;
  }
  EXPECT_GE(killed, 20);
}

TEST_P(Resume, GoesOnAfterMaxTime) {
  const TestFolder folder;
  folder.write("case.toml", GetParam().text(400));
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

TEST_P(Resume, OfAFinishedRunSolvesNothing) {
  const TestFolder folder;
  folder.write("case.toml", GetParam().text(3));
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o whole").code, 0);
  std::filesystem::copy(folder.path() / "whole", folder.path() / "again",
                        std::filesystem::copy_options::recursive);
  std::filesystem::remove(folder.path() / "again/rao_points.csv");
  const ProgramResult result = run_floe(folder, "run case.toml --allow-coarse -o again --resume");
  ASSERT_EQ(result.code, 0) << result.error;
  expect_same_products(folder, "whole", "again");
  EXPECT_GT(solving_seconds(folder, "whole"), 0.0);
  EXPECT_EQ(solving_seconds(folder, "again"), 0.0);
  const auto account = nlohmann::json::parse(folder.read("again/run.json"));
  EXPECT_GT(account.at("seconds_before").get<double>(), solving_seconds(folder, "whole"));
}

TEST(ResumeWithSeas, ComputesADamagedRecordAgainAndSaysSo) {
  const TestFolder folder;
  folder.write("case.toml", kModalWithSeas.text(3));
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

// A byte of every record at once: all are noticed and computed again. That no byte goes unnoticed
// is the matter of Record, NoticesEveryChangedByte; here are every fifth, which takes minutes
TEST_P(ResumeLong, ComputesARecordWithAnyByteFlippedAgain) {
  const TestFolder folder;
  std::string text = GetParam().text(2);
  const std::string mesh = "nx = 4, ny = 2";
  folder.write("case.toml", text.replace(text.find(mesh), mesh.size(), "nx = 1, ny = 1"));
  const std::string run = "run case.toml --allow-coarse --threads 1 ";
  ASSERT_EQ(run_floe(folder, run + "-o whole").code, 0);
  std::map<std::string, std::string> good;
  std::size_t longest = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "whole/records"))
    if (entry.path().extension() == ".rec") {
      const std::string name = "records/" + entry.path().filename().string();
      good[name] = folder.read("whole/" + name);
      if (name.find("sea_observation") == std::string::npos)
        longest = std::max(longest, good[name].size());
    }
  std::mt19937 random(3);
  for (std::size_t place = 0; place < longest; place += 5) {
    std::filesystem::remove_all(folder.path() / "again");
    std::filesystem::copy(folder.path() / "whole", folder.path() / "again",
                          std::filesystem::copy_options::recursive);
    for (const auto& [name, bytes] : good) {
      std::string bad = bytes;
      bad[place % bad.size()] ^= static_cast<char>(1u << (random() % 8));
      folder.write("again/" + name, bad);
    }
    const ProgramResult result = run_floe(folder, run + "-o again --resume");
    ASSERT_EQ(result.code, 0) << place << ": " << result.error;
    EXPECT_THAT(result.output, HasSubstr("frequency_00001.rec is damaged (moved to records/bad/"));
    ASSERT_NO_FATAL_FAILURE(expect_same_products(folder, "whole", "again")) << place;
    for (const auto& [name, bytes] : good)
      if (name.find("frequency") == std::string::npos) {  // it tells a time
        ASSERT_TRUE(folder.read("again/" + name) == bytes) << name << " " << place;
      }
  }
  RecordProperty("bytes", static_cast<int>(longest));
}

TEST_P(Resume, RefusesTheResultsOfAnotherCase) {
  const TestFolder folder;
  folder.write("case.toml", GetParam().text(3));
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse").code, 0);
  folder.write("case.toml", "title = \"only a title\"\n" + GetParam().text(3));
  EXPECT_EQ(run_floe(folder, "run case.toml --allow-coarse --resume").code, 0);
  std::string other = GetParam().text(3);
  other.replace(other.find("thickness = 2.0"), 15, "thickness = 2.5");
  folder.write("case.toml", other);
  const ProgramResult result = run_floe(folder, "run case.toml --allow-coarse --resume");
  EXPECT_EQ(result.code, 9);
  EXPECT_THAT(result.error, HasSubstr("holds results of another case: /options/plate/thickness"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "case.out/rao_points.csv"));
  EXPECT_EQ(run_floe(folder, "run case.toml --allow-coarse --resume --fresh").code, 2);
}

TEST_P(Resume, StartsWhereThereIsNothing) {
  const TestFolder folder;
  folder.write("case.toml", GetParam().text(2));
  const ProgramResult result = run_floe(folder, "run case.toml --allow-coarse --resume");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_THAT(result.output, Not(HasSubstr("damaged")));
}

}  // namespace
}  // namespace floe
