#include "csv.hpp"
#include "floe_program.hpp"

#include <floe/mesh/gmsh.hpp>
#include <floe/mesh/rectangle.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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

// Both halves of a mesh with the properties of the plate: the answers of the uniform plate
TEST(Converge, RefinesRegionsWithTheMesh) {
  const TestFolder folder;
  const mesh::Q8Mesh plate =
      mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = 4, .ny = 2});
  mesh::ElementGroup left{"left", {}};
  for (Index e = 0; e < plate.element_count(); ++e)
    if (plate.element_nodes(e).row(0).mean() < 0.0) left.elements.push_back(e);
  mesh::write_gmsh(folder.path() / "halves.msh", plate, {left});
  const std::string uniform =
      test::with("rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }",
                 "file = \"halves.msh\"") +
      kOutput;
  const auto summary_of = [&](const std::string& name, const std::string& region) {
    folder.write(name + ".toml", uniform + region);
    const ProgramResult result = run_floe(folder, "converge " + name + ".toml");
    EXPECT_EQ(result.code, 0) << result.error;
    return test::read_csv(folder.path() / (name + ".convergence/convergence.csv"))
        .where("quantity", "deflection")
        .numbers("extrapolated_abs");
  };
  const auto plain = summary_of("plain", "");
  const auto same = summary_of("same", "[[plate.region]]\nname = \"left\"\n");
  ASSERT_EQ(same.size(), plain.size());
  for (std::size_t i = 0; i < same.size(); ++i) EXPECT_NEAR(same[i], plain[i], 1e-6 * plain[i]);
  const auto thick = summary_of("thick", "[[plate.region]]\nname = \"left\"\nthickness = 4.0\n");
  EXPECT_GT(std::abs(thick[0] - plain[0]), 1e-2 * plain[0]);
}

TEST(Converge, KnowsTheDirectRoute) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput + "[solver]\nroute = \"direct\"\n");
  const ProgramResult result = run_floe(folder, "converge tiny.toml");
  ASSERT_EQ(result.code, 0) << result.error;
  const auto summary = test::read_csv(folder.path() / "tiny.convergence/convergence_summary.csv");
  for (const double error : summary.numbers("mode_error")) EXPECT_EQ(error, 0.0);
  for (const double error : summary.numbers("mesh_error")) EXPECT_GT(error, 0.0);
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
