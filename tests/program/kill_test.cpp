#include "floe_program.hpp"
#include "stored_products.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <random>

// Runs that die, or whose disk does, at any call that changes a file.
namespace floe {
namespace {

using test::expect_same_products;
using test::kCaseText;
using test::ProgramResult;
using test::run_floe;
using test::TestFolder;
using test::with;
using testing::AnyOf;
using testing::HasSubstr;

// Two frequencies with node fields, a sea with few transfer functions
const std::string kSmallCase = kCaseText + R"([modes]
count = 6
[sea_grid]
omega = { from = 0.4, to = 0.6 }
tolerance = 0.02
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
quantities = ["deflection", "bending_moment_x"]
)";

const std::string kRun = "run case.toml --allow-coarse --threads 1 --progress=none -o ";

std::string preloaded(const std::string& variables) {
  return "LD_PRELOAD='" FLOE_FAULT_SHIM "' " + variables;
}

// Stores the uninterrupted run and tells how many calls of it change files
int store_whole_run(const TestFolder& folder) {
  folder.write("case.toml", kSmallCase);
  const ProgramResult whole = run_floe(folder, kRun + "whole", preloaded("FLOE_FAULT_COUNT=count"));
  EXPECT_EQ(whole.code, 0) << whole.error;
  return std::stoi(folder.read("count"));
}

ProgramResult run_with_fault(const TestFolder& folder, int call, const std::string& fault) {
  return run_floe(folder, kRun + "parts --resume",
                  preloaded("FLOE_FAULT_AT=" + std::to_string(call) + " FLOE_FAULT=" + fault));
}

void kill_at_every(int step) {
  const TestFolder folder;
  const int count = store_whole_run(folder);
  ASSERT_GT(count, 100);
  for (int call = 1; call <= count; call += step) {
    std::filesystem::remove_all(folder.path() / "parts");
    ASSERT_EQ(run_with_fault(folder, call, "kill").code, 137) << "call " << call << " of " << count;
    const ProgramResult resumed = run_floe(folder, kRun + "parts --resume");
    ASSERT_EQ(resumed.code, 0) << "call " << call << ": " << resumed.error;
    EXPECT_EQ(resumed.error.find("damaged"), std::string::npos) << resumed.error;
    ASSERT_NO_FATAL_FAILURE(expect_same_products(folder, "whole", "parts")) << "call " << call;
  }
}

TEST(KilledRun, GoesOnToTheSameBytesAfterEvery199thCall) { kill_at_every(199); }

TEST(KilledRunLong, GoesOnToTheSameBytesAfterEveryCall) { kill_at_every(1); }

TEST(KilledRun, GoesOnThoughEveryResumptionIsKilledToo) {
  const TestFolder folder;
  const int count = store_whole_run(folder);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> call(count / 8, count / 2);
  int killed = 0;
  for (; killed < 12; ++killed)
    if (run_with_fault(folder, call(random), "kill").code == 0) break;
  EXPECT_GT(killed, 1);
  const ProgramResult last =
      run_floe(folder, "run case.toml --allow-coarse --threads 3 -o parts --resume");
  ASSERT_EQ(last.code, 0) << last.error;
  expect_same_products(folder, "whole", "parts");
}

TEST(KilledRun, IsReplacedWhole) {
  const TestFolder folder;
  const int count = store_whole_run(folder);
  // Killed while --fresh clears what was there, whatever is left
  for (int call = 1; call < 60; call += 7) {
    std::filesystem::remove_all(folder.path() / "parts");
    std::filesystem::copy(folder.path() / "whole", folder.path() / "parts",
                          std::filesystem::copy_options::recursive);
    ASSERT_EQ(run_floe(folder, kRun + "parts --fresh",
                       preloaded("FLOE_FAULT=kill FLOE_FAULT_AT=" + std::to_string(call)))
                  .code,
              137);
    const ProgramResult again = run_floe(folder, kRun + "parts --fresh");
    ASSERT_EQ(again.code, 0) << "call " << call << " of " << count << ": " << again.error;
    ASSERT_NO_FATAL_FAILURE(expect_same_products(folder, "whole", "parts")) << "call " << call;
  }
}

TEST(FailingDisk, EndsARunWithSevenAndKeepsWhatWasThere) {
  const TestFolder folder;
  const int count = store_whole_run(folder);
  int failed = 0;
  for (const auto& [error, text] :
       {std::pair{ENOSPC, "No space left on device"}, std::pair{EIO, "Input/output error"},
        std::pair{EDQUOT, "Disk quota exceeded"}}) {
    for (int call = 2 + error % 7; call <= count; call += 311) {
      std::filesystem::remove_all(folder.path() / "parts");
      const std::string fault = std::to_string(error) + " FLOE_FAULT_FOREVER=1";
      const ProgramResult result = run_with_fault(folder, call, fault);
      // The last calls only remove what is not needed
      ASSERT_THAT(result.code, AnyOf(7, 0)) << "call " << call << ": " << result.error;
      if (result.code == 7) {
        EXPECT_THAT(result.error, HasSubstr("floe: error: cannot write "));
        // The netCDF library has words of its own
        EXPECT_THAT(result.error, AnyOf(HasSubstr(text), HasSubstr("result.nc"))) << call;
        ++failed;
      }
      const ProgramResult resumed = run_floe(folder, kRun + "parts --resume");
      ASSERT_EQ(resumed.code, 0) << "call " << call << ": " << resumed.error;
      ASSERT_NO_FATAL_FAILURE(expect_same_products(folder, "whole", "parts")) << "call " << call;
    }
  }
  EXPECT_GT(failed, 15);
}

TEST(FailingDisk, IsRefusedBeforeItFills) {
  const TestFolder folder;
  folder.write("case.toml", kSmallCase);
  const ProgramResult result = run_floe(folder, kRun + "out", preloaded("FLOE_FREE_SPACE=4096"));
  EXPECT_EQ(result.code, 6);
  EXPECT_THAT(result.error, HasSubstr("invalid disk need = "));
  EXPECT_THAT(result.error, HasSubstr("(must be at most 4.10 kB, what is free where out lies"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

}  // namespace
}  // namespace floe
