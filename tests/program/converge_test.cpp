#include "csv.hpp"
#include "floe_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace floe {
namespace {

using test::kCaseText;
using test::ProgramResult;
using test::run_floe;
using test::TestFolder;
using testing::HasSubstr;

const std::string kOutput = R"([modes]
count = 6
[output]
points = { P1 = [-150, -30], P5 = [0, 0] }
quantities = ["deflection", "bending_moment_x"]
)";

TEST(Converge, WritesTheErrorOfEveryAnswer) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput);
  const ProgramResult result = run_floe(folder, "converge tiny.toml");
  ASSERT_EQ(result.code, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("solved with 37 nodes and 6 modes"));
  EXPECT_THAT(result.output, HasSubstr("solved with 37 nodes and 12 modes"));
  const auto answers = test::read_csv(folder.path() / "tiny.convergence/convergence.csv");
  EXPECT_EQ(answers.row_count(), 2u * 2u * 2u * 2u);
  const auto summary = test::read_csv(folder.path() / "tiny.convergence/convergence_summary.csv");
  EXPECT_EQ(summary.row_count(), 2u * 2u);
  // The case's own answers are those of a run
  ASSERT_EQ(run_floe(folder, "run tiny.toml").code, 0);
  const auto run = test::read_csv(folder.path() / "tiny.out/rao_points.csv");
  EXPECT_EQ(answers.where("quantity", "deflection").where("point", "P1").numbers("abs").at(0),
            run.where("point", "P1").numbers("abs_w").at(0));
  // Its meshes can be used
  folder.write("fine.toml",
               test::with("rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }",
                          "file = \"tiny.convergence/refined_1.msh\""));
  EXPECT_THAT(run_floe(folder, "check fine.toml").output, HasSubstr("121 nodes, 32 elements"));
}

TEST(Converge, KeepsWhatIsThere) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput);
  ASSERT_EQ(run_floe(folder, "converge tiny.toml -o out").code, 0);
  EXPECT_EQ(run_floe(folder, "converge tiny.toml -o out").code, 9);
  EXPECT_EQ(run_floe(folder, "converge tiny.toml -o out --fresh").code, 0);
  std::filesystem::create_directory(folder.path() / "mine");
  folder.write("mine/convergence.csv", "mine");
  EXPECT_EQ(run_floe(folder, "converge tiny.toml -o mine").code, 9);
  EXPECT_EQ(folder.read("mine/convergence.csv"), "mine");
}

TEST(Converge, NeedsPoints) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText);
  const ProgramResult result = run_floe(folder, "converge tiny.toml");
  EXPECT_EQ(result.code, 3);
  EXPECT_THAT(result.error, HasSubstr("missing output.points"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "tiny.convergence"));
}

}  // namespace
}  // namespace floe
