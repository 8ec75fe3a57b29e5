#include "floe_program.hpp"
#include "sanitized.hpp"
#include "stored_products.hpp"
#include "sweep_cases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <random>

// Runs that die, or whose disk does, at any call that changes a file.
namespace floe {
namespace {

using test::expect_same_products;
using test::kDirect;
using test::kModalWithSeas;
using test::ProgramResult;
using test::run_floe;
using test::SweepCase;
using test::TestFolder;
using testing::AnyOf;
using testing::HasSubstr;

constexpr int kFolderSyncs = 20;
const std::string kRun = "run case.toml --allow-coarse --threads 1 --progress=none -o ";

std::string preloaded(const std::string& variables) {
  return test::preloading(FLOE_FAULT_SHIM) + variables;
}

// Stores the uninterrupted run and tells how many calls of it change files
int store_whole_run(const TestFolder& folder, const SweepCase& sweep) {
  folder.write("case.toml", sweep.text(2));
  const ProgramResult whole = run_floe(folder, kRun + "whole", preloaded("FLOE_FAULT_COUNT=count"));
  EXPECT_EQ(whole.code, 0) << whole.error;
  return std::stoi(folder.read("count"));
}

ProgramResult run_with_fault(const TestFolder& folder, int call, const std::string& fault) {
  return run_floe(folder, kRun + "parts --resume",
                  preloaded("FLOE_FAULT_AT=" + std::to_string(call) + " FLOE_FAULT=" + fault));
}

void kill_at_every(int step, const SweepCase& sweep) {
  const TestFolder folder;
  const int count = store_whole_run(folder, sweep);
  ASSERT_GT(count, 50);
  for (int call = 1; call <= count; call += step) {
    std::filesystem::remove_all(folder.path() / "parts");
    const int code = run_with_fault(folder, call, "kill").code;
    // NOTE: the folder is synced once a second, so a slower run makes a few calls more
    if (code == 0 && call > count - kFolderSyncs) break;
    ASSERT_EQ(code, 137) << "call " << call << " of " << count;
    const ProgramResult resumed = run_floe(folder, kRun + "parts --resume");
    ASSERT_EQ(resumed.code, 0) << "call " << call << ": " << resumed.error;
    EXPECT_EQ(resumed.error.find("damaged"), std::string::npos) << resumed.error;
    ASSERT_NO_FATAL_FAILURE(expect_same_products(folder, "whole", "parts")) << "call " << call;
  }
}

class KilledRun : public testing::TestWithParam<SweepCase> {};
class KilledRunLong : public KilledRun {};

TEST_P(KilledRun, GoesOnToTheSameBytesAfterEvery97thCall) { kill_at_every(97, GetParam()); }

TEST_P(KilledRunLong, GoesOnToTheSameBytesAfterEveryCall) { kill_at_every(1, GetParam()); }

const auto kName = [](const auto& sweep) { return sweep.param.name; };
INSTANTIATE_TEST_SUITE_P(All, KilledRun, testing::Values(kModalWithSeas, kDirect), kName);
INSTANTIATE_TEST_SUITE_P(All, KilledRunLong, testing::Values(kModalWithSeas, kDirect), kName);

TEST_P(KilledRun, GoesOnThoughEveryResumptionIsKilledToo) {
  const TestFolder folder;
  const int count = store_whole_run(folder, GetParam());
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

TEST_P(KilledRun, IsReplacedWhole) {
  const TestFolder folder;
  const int count = store_whole_run(folder, GetParam());
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
  const int count = store_whole_run(folder, kModalWithSeas);
  int failed = 0;
  for (const auto& [error, text] :
       {std::pair{ENOSPC, "No space left on device"}, std::pair{EIO, "Input/output error"},
        std::pair{EDQUOT, "Disk quota exceeded"}}) {
    for (int call = 2 + error % 7; call <= count; call += 29) {
      std::filesystem::remove_all(folder.path() / "parts");
      const std::string fault = std::to_string(error) + " FLOE_FAULT_FOREVER=1";
      const ProgramResult result = run_with_fault(folder, call, fault);
      // The last calls only remove what is not needed
      ASSERT_THAT(result.code, AnyOf(7, 0)) << "call " << call << ": " << result.error;
      if (result.code == 7) {
        EXPECT_THAT(result.error, HasSubstr("floe: error: cannot write "));
        EXPECT_THAT(result.error, HasSubstr(text)) << call;
        ++failed;
      }
      const ProgramResult resumed = run_floe(folder, kRun + "parts --resume");
      ASSERT_EQ(resumed.code, 0) << "call " << call << ": " << resumed.error;
      ASSERT_NO_FATAL_FAILURE(expect_same_products(folder, "whole", "parts")) << "call " << call;
    }
  }
  EXPECT_GT(failed, 15);
}

// No byte more for one file, however the library beneath writes it
TEST(FailingDisk, LeavesRecordsAndASevenWhileResultNcIsWritten) {
  const TestFolder folder;
  store_whole_run(folder, kModalWithSeas);
  for (const char* name : {"result.nc", "node_spectra.nc", "statistics.vtu", "run.json"}) {
    std::filesystem::remove_all(folder.path() / "parts");
    const ProgramResult result = run_floe(
        folder, kRun + "parts", preloaded(std::string("FLOE_FAULT=28 FLOE_FAULT_FILE=") + name));
    EXPECT_EQ(result.code, 7) << name << ": " << result.error;
    EXPECT_THAT(result.error, HasSubstr(name));
    EXPECT_THAT(result.error, HasSubstr("No space left on device"));
    const bool begun = std::string(name) != "run.json";
    EXPECT_EQ(std::filesystem::exists(folder.path() / "parts/records/frequency_00002.rec"), begun);
    const ProgramResult resumed = run_floe(folder, kRun + "parts --resume");
    ASSERT_EQ(resumed.code, 0) << name << ": " << resumed.error;
    ASSERT_NO_FATAL_FAILURE(expect_same_products(folder, "whole", "parts")) << name;
  }
}

TEST(FailingDisk, IsRefusedBeforeItFills) {
  const TestFolder folder;
  folder.write("case.toml", kModalWithSeas.text(2));
  const ProgramResult result = run_floe(folder, kRun + "out", preloaded("FLOE_FREE_SPACE=4096"));
  EXPECT_EQ(result.code, 6);
  EXPECT_THAT(result.error, HasSubstr("invalid disk need = "));
  EXPECT_THAT(result.error, HasSubstr("(must be at most 4.10 kB, what is free where out lies"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

}  // namespace
}  // namespace floe
