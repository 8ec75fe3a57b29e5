#include "floe_program.hpp"
#include "stored_products.hpp"
#include "sweep_cases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

// Sweeps in parts, and their pieces put together.
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

ProgramResult run_shard(const TestFolder& folder, int index, int count) {
  const std::string part = std::to_string(index);
  return run_floe(folder, "run case.toml --allow-coarse --progress=none --threads 1 --shard " +
                              part + "/" + std::to_string(count) + " -o part" + part);
}

std::string parts(int count) {
  std::string names;
  for (int i = 1; i <= count; ++i) names += " part" + std::to_string(i);
  return names;
}

class Merge : public testing::TestWithParam<SweepCase> {};

INSTANTIATE_TEST_SUITE_P(All, Merge, testing::Values(kModalWithSeas, kDirect),
                         [](const auto& sweep) { return sweep.param.name; });

TEST_P(Merge, FortyShardsGiveTheBytesOfOneRun) {
  const TestFolder folder;
  folder.write("case.toml", GetParam().text(41));
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o whole").code, 0);
  for (int index = 1; index <= 40; ++index) {
    const ProgramResult part = run_shard(folder, index, 40);
    ASSERT_EQ(part.code, 0) << part.error;
  }
  const ProgramResult merged = run_floe(folder, "merge" + parts(40) + " -o merged");
  ASSERT_EQ(merged.code, 0) << merged.error;
  expect_same_products(folder, "whole", "merged");
  const auto run = nlohmann::json::parse(folder.read("merged/run.json"));
  EXPECT_EQ(run.at("status"), "complete");
  EXPECT_EQ(run.at("frequencies").size(), 41u);
  // As good as any run: nothing is left to do, and nothing is left behind
  EXPECT_EQ(run_floe(folder, "run case.toml --allow-coarse --resume -o merged").code, 0);
  expect_same_products(folder, "whole", "merged");
  EXPECT_EQ(run_floe(folder, "merge" + parts(40) + " -o merged").code, 9);
  EXPECT_EQ(run_floe(folder, "merge" + parts(40) + " -o merged --fresh").code, 0);
}

TEST_P(Merge, MoreShardsThanFrequenciesLeaveSomeWithNothing) {
  const TestFolder folder;
  folder.write("case.toml", GetParam().text(2));
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o whole").code, 0);
  for (int index = 1; index <= 4; ++index) ASSERT_EQ(run_shard(folder, index, 4).code, 0);
  ASSERT_EQ(run_floe(folder, "merge" + parts(4) + " -o merged").code, 0);
  expect_same_products(folder, "whole", "merged");
}

TEST(MergeWithSeas, ListsGapsWithEightAndARunFillsThem) {
  const TestFolder folder;
  folder.write("case.toml", kModalWithSeas.text(7));
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o whole").code, 0);
  for (int index = 1; index <= 3; ++index) ASSERT_EQ(run_shard(folder, index, 3).code, 0);
  const ProgramResult merged = run_floe(folder, "merge part1 part2 -o merged");
  EXPECT_EQ(merged.code, 8);
  // Places 3 and 6 of 7 from 0.2 to 0.6 rad/s
  EXPECT_THAT(merged.error, HasSubstr("2 of 7 frequencies are not solved: 0.3333, 0.5333 rad/s; "
                                      "nor are the seas"));
  EXPECT_THAT(merged.error, HasSubstr("--resume -o merged"));
  EXPECT_EQ(run_floe(folder, "run case.toml --allow-coarse --resume -o merged").code, 0);
  expect_same_products(folder, "whole", "merged");
}

TEST_P(Merge, TakesOverlapsThatAreEqualOnly) {
  const TestFolder folder;
  folder.write("case.toml", GetParam().text(4));
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o whole").code, 0);
  ASSERT_EQ(run_shard(folder, 1, 2).code, 0);
  ASSERT_EQ(run_shard(folder, 2, 2).code, 0);
  EXPECT_EQ(run_floe(folder, "merge part1 whole part2 part1 -o merged").code, 0);
  expect_same_products(folder, "whole", "merged");

  // The same place with other numbers and a good checksum: another case under this manifest
  std::string other = GetParam().text(4);
  other.replace(other.find("thickness = 2.0"), 15, "thickness = 2.5");
  folder.write("other.toml", other);
  ASSERT_EQ(run_floe(folder, "run other.toml --allow-coarse -o other").code, 0);
  const ProgramResult mixed = run_floe(folder, "merge part1 other -o mixed");
  EXPECT_EQ(mixed.code, 9);
  EXPECT_THAT(mixed.error, HasSubstr("other and part1 are of different cases: "
                                     "/options/plate/thickness differ"));
  folder.write("part1/records/frequency_00001.rec",
               folder.read("other/records/frequency_00001.rec"));
  const ProgramResult foreign = run_floe(folder, "merge part1 part2 -o mixed");
  EXPECT_EQ(foreign.code, 9);
  EXPECT_THAT(foreign.error, HasSubstr("frequency_00001.rec is not one of its manifest's case"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "mixed"));
}

TEST_P(Merge, RefusesADamagedRecord) {
  const TestFolder folder;
  folder.write("case.toml", GetParam().text(4));
  ASSERT_EQ(run_shard(folder, 1, 2).code, 0);
  ASSERT_EQ(run_shard(folder, 2, 2).code, 0);
  std::string record = folder.read("part2/records/frequency_00002.rec");
  record[record.size() / 2] ^= 2;
  folder.write("part2/records/frequency_00002.rec", record);
  const ProgramResult merged = run_floe(folder, "merge part1 part2 -o merged");
  EXPECT_EQ(merged.code, 9);
  EXPECT_THAT(merged.error, HasSubstr("part2/records/frequency_00002.rec is damaged"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "merged"));
  // The part mends itself
  EXPECT_EQ(run_floe(folder, "run case.toml --allow-coarse --shard 2/2 -o part2 --resume").code, 0);
  EXPECT_EQ(run_floe(folder, "merge part1 part2 -o merged").code, 0);
}

TEST(Shard, IsResumedAsTheSameShardOnly) {
  const TestFolder folder;
  folder.write("case.toml", kDirect.text(4));
  ASSERT_EQ(run_shard(folder, 1, 2).code, 0);
  const ProgramResult other =
      run_floe(folder, "run case.toml --allow-coarse --shard 2/2 -o part1 --resume");
  EXPECT_EQ(other.code, 9);
  EXPECT_THAT(other.error, HasSubstr("/shard/index differ"));
  EXPECT_EQ(run_floe(folder, "run case.toml --allow-coarse -o part1 --resume").code, 9);
  for (const char* shard : {"0/2", "3/2", "1", "1/", "/2", "a/b", "1/2/3", "-1/2"})
    EXPECT_EQ(run_floe(folder, std::string("run case.toml --shard=") + shard).code, 2) << shard;
}

}  // namespace
}  // namespace floe
