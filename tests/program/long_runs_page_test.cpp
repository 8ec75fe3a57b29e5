#include "floe_program.hpp"
#include "stored_products.hpp"
#include "sweep_cases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

// docs/howto/long_runs.md does what it says: its commands and its batch script are run.
namespace floe {
namespace {

using test::expect_same_products;
using test::kDirect;
using test::ProgramResult;
using test::run_floe;
using test::TestFolder;
using testing::HasSubstr;

// The fenced blocks of the page
std::vector<std::string> blocks() {
  std::ifstream page(FLOE_SOURCE_DIR "/docs/howto/long_runs.md");
  std::vector<std::string> found;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) found.emplace_back();
    } else if (inside) {
      found.back() += line + "\n";
    }
  }
  return found;
}

// Lines of the page that call floe, without the prompt; not those of the script
std::vector<std::string> commands() {
  std::vector<std::string> found;
  for (const std::string& block : blocks()) {
    std::istringstream lines(block);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("$ ")) line = line.substr(2);
      if (line.starts_with("floe ") && !line.ends_with("\\")) found.push_back(line);
    }
  }
  return found;
}

std::string batch_script() {
  for (const std::string& block : blocks())
    if (block.starts_with("#!/bin/bash")) return block;
  return "";
}

// Any command of a shell, with floe on the path and a scontrol that notes what it is asked
ProgramResult run_shell(const TestFolder& folder, const std::string& command) {
  const std::string bin = std::filesystem::path(FLOE_PROGRAM).parent_path().string();
  folder.write("script.sh", command + "\n");
  folder.write("scontrol", "#!/bin/sh\necho \"$@\" >>requeued\n");
  std::filesystem::permissions(folder.path() / "scontrol", std::filesystem::perms::owner_all);
  return run_floe(folder, "--version >version; PATH=\"" + bin + ":$PWD:$PATH\" bash script.sh");
}

TEST(LongRunsPage, CommandsDoWhatTheySay) {
  const TestFolder folder;
  folder.write("plate.toml", kDirect.text(7));
  std::string said;
  for (const std::string& command : commands()) {
    said += command + "\n";
    std::string before;
    if (command.starts_with("floe merge part1"))
      before =
          "cp -r plate.out whole; rm -r plate.out; "
          "floe run plate.toml --shard 2/3 -o part2 && "
          "floe run plate.toml --shard 3/3 -o part3 && ";
    if (command.starts_with("floe merge parts/*"))
      before = "rm -r plate.out; mkdir parts; mv part1 part2 part3 parts; ";
    const ProgramResult result = run_shell(folder, before + command);
    EXPECT_EQ(result.code, 0) << command << "\n" << result.error;
  }
  expect_same_products(folder, "whole", "plate.out");
  for (const char* word : {"--resume", "floe status", "--shard", "floe merge", "floe export"})
    EXPECT_THAT(said, HasSubstr(word));
}

TEST(LongRunsPage, BatchScriptGoesOnWhereTheQueueStoppedIt) {
  const TestFolder folder;
  folder.write("plate.toml", kDirect.text(120));
  folder.write("plate.sbatch", batch_script());
  const auto task = [](int index) {
    return "SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_COUNT=2 SLURM_CPUS_PER_TASK=1 "
           "SLURM_ARRAY_TASK_ID=" +
           std::to_string(index) + " bash plate.sbatch";
  };
  // The signal comes as Slurm sends it, to the shell
  const ProgramResult stopped = run_shell(
      folder, task(1) +
                  " & shell=$!; while [ ! -e parts/01/records/frequency_00003.rec ]; do sleep "
                  "0.01; done; kill -USR1 $shell; wait $shell");
  EXPECT_EQ(stopped.code, 75) << stopped.error;
  EXPECT_THAT(stopped.error, HasSubstr("stopped by SIGUSR1"));
  EXPECT_EQ(folder.read("requeued"), "requeue 7_1\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "parts/01/records/frequency_00119.rec"));
  for (int index = 1; index <= 2; ++index) {
    const ProgramResult result = run_shell(folder, task(index));
    ASSERT_EQ(result.code, 0) << result.error;
  }
  EXPECT_EQ(folder.read("requeued"), "requeue 7_1\n") << "once";
  EXPECT_EQ(run_floe(folder, "merge parts/* -o plate.out").code, 0);
  ASSERT_EQ(run_floe(folder, "run plate.toml -o whole").code, 0);
  expect_same_products(folder, "whole", "plate.out");
}

}  // namespace
}  // namespace floe
