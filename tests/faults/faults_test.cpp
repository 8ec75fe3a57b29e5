#include "fault.hpp"
#include "rows.hpp"
#include "sanitized.hpp"
#include "test_paths.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace floe::test {
namespace {

using testing::HasSubstr;

// Every file below the folder, with what a link points to left alone
std::map<std::string, std::string> content_of(const TestFolder& folder) {
  std::map<std::string, std::string> content;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
    const std::string name = std::filesystem::relative(entry.path(), folder.path()).string();
    constexpr std::uintmax_t kCompared = 1 << 20;
    const bool small = entry.is_regular_file() && entry.file_size() < kCompared;
    content[name] = small ? folder.read(name) : "";
  }
  return content;
}

bool may_change(const std::string& name, int code) {
  return name.starts_with("case.out") && (code == 0 || code == 1 || code >= 7) && code != 9 &&
         code != 10;
}

std::vector<Fault> all_faults() {
  std::vector<Fault> all = case_faults();
  for (const auto& part : {mesh_faults(), sea_faults(), resource_faults(), disk_faults()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

class Faults : public testing::TestWithParam<Fault> {};

TEST_P(Faults, AreSurvived) { expect_survived(GetParam()); }

INSTANTIATE_TEST_SUITE_P(All, Faults, testing::ValuesIn(all_faults()),
                         [](const testing::TestParamInfo<Fault>& fault) {
                           return "Row" + std::to_string(fault.param.row) + fault.param.name;
                         });

// All sources of tests, one text
std::string test_sources() {
  std::ostringstream text;
  for (const char* root : {"tests", "fmm/tests"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(FLOE_SOURCE_DIR) / root))
      if (entry.path().extension() == ".cpp") text << std::ifstream(entry.path()).rdbuf();
  return text.str();
}

TEST(FaultList, TestsEveryRowOrSaysWhyNot) {
  std::set<int> tested;
  for (const Fault& fault : all_faults()) tested.insert(fault.row);
  const std::string sources = test_sources();
  for (const Row& row : fault_rows()) {
    EXPECT_TRUE(tested.contains(row.number) || !row.elsewhere.empty() || !row.reason.empty())
        << "row " << row.number << " (" << row.fault << ") has no test and no reason";
    for (const std::string& test : row.elsewhere)
      EXPECT_TRUE(sources.find("(" + test + ")") != std::string::npos)
          << "row " << row.number << " names a test that is not there: " << test;
    tested.erase(row.number);
  }
  EXPECT_THAT(tested, testing::IsEmpty()) << "faults of rows that the list does not have";
}

}  // namespace

void expect_survived(const Fault& fault) {
  if (test::kSanitized && fault.before.find("ulimit -v") != std::string::npos)
    GTEST_SKIP() << "not with the sanitizers";
  // Lay out what the fault needs
  const TestFolder folder;
  if (!fault.text.empty()) folder.write("case.toml", fault.text);
  if (fault.prepare) fault.prepare(folder);
  const auto before = content_of(folder);

  // Run the program, but not for ever
  const ProgramResult result =
      run_floe(folder, fault.arguments,
               fault.before + " timeout -s KILL " + (test::kSanitized ? "280" : "60"));
  EXPECT_EQ(result.code, fault.code) << result.output << result.error;

  // One clear line, or none where all went well or nobody listens
  const bool heard = fault.arguments.find("2>&-") == std::string::npos;
  const bool failed = fault.code != 0 && heard;
  EXPECT_THAT(failed ? result.error : result.output, HasSubstr(fault.says));
  const std::string head = "floe: error: ";
  const auto first = result.error.find(head);
  EXPECT_EQ(first != std::string::npos, failed) << result.error;
  if (failed) {
    EXPECT_EQ(result.error.find(head, first + 1), std::string::npos) << result.error;
    EXPECT_EQ(result.error.find('\n', first), result.error.size() - 1) << result.error;
    EXPECT_LT(result.error.size(), 10000u) << result.error;
  }

  // Nothing was touched outside the output directory
  const auto after = content_of(folder);
  for (const auto& [name, content] : after)
    if (!may_change(name, fault.code)) {
      EXPECT_TRUE(before.contains(name) && before.at(name) == content) << name;
    }
  for (const auto& [name, content] : before)
    EXPECT_TRUE(after.contains(name) || may_change(name, fault.code)) << name << " is gone";
}

std::string with_mesh_file(const std::string& name) {
  return with("rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }",
              "file = \"" + name + "\"");
}

}  // namespace floe::test
