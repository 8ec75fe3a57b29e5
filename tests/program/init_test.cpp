#include "floe_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace floe {
namespace {

using test::ProgramResult;
using test::run_floe;
using test::TestFolder;
using testing::AllOf;
using testing::HasSubstr;

const std::string kMesh = std::string(FLOE_SOURCE_DIR) + "/meshes/lshape.msh";

TEST(InitCommand, WritesACaseOfAMeshAndASeaThatCheckAccepts) {
  const TestFolder folder;
  std::filesystem::create_directory(folder.path() / "cases");
  std::filesystem::copy_file(kMesh, folder.path() / "airport.msh");
  const ProgramResult made =
      run_floe(folder, "init cases/airport.toml --mesh airport.msh --sea 2 6.3 --heading 30");
  ASSERT_EQ(made.code, 0) << made.error;
  EXPECT_THAT(folder.read("cases/airport.toml"),
              AllOf(HasSubstr("title = \"airport\""), HasSubstr("file = \"../airport.msh\""),
                    HasSubstr("significant_height = 2 "), HasSubstr("significant_period = 6.3 "),
                    HasSubstr("mean_heading_deg = [30]")));
  const ProgramResult check = run_floe(folder, "check cases/airport.toml");
  EXPECT_EQ(check.code, 0) << check.error;
  EXPECT_THAT(check.output, HasSubstr("seas"));
}

TEST(InitCommand, WritesARectangleWithoutASeaThatCheckAccepts) {
  const TestFolder folder;
  ASSERT_EQ(run_floe(folder, "init a.toml --length 90 --width 30 --thickness 1 --depth inf").code,
            0);
  EXPECT_THAT(folder.read("a.toml"),
              AllOf(HasSubstr("depth = inf"), HasSubstr("nx = 15, ny = 5"),
                    HasSubstr("\n# [[sea]]"), HasSubstr("from = [-45, 0], to = [45, 0]")));
  const ProgramResult check = run_floe(folder, "check a.toml");
  EXPECT_EQ(check.code, 0) << check.error;
}

TEST(InitCommand, AsksForModesOfEveryPlate) {
  const TestFolder folder;
  ASSERT_EQ(run_floe(folder,
                     "mesh modules --module-length 20 --module-width 10 --modules-x 12 "
                     "--modules-y 1 --gap 2 --element-size 5 -o row.msh")
                .code,
            0);
  ASSERT_EQ(run_floe(folder, "init row.toml --mesh row.msh --sea 1 6").code, 0);
  EXPECT_THAT(folder.read("row.toml"), HasSubstr("\n[modes]\ncount = 72 "));
  const ProgramResult check = run_floe(folder, "check row.toml");
  EXPECT_EQ(check.code, 0) << check.error;
}

TEST(InitCommand, OverwritesNothing) {
  const TestFolder folder;
  folder.write("a.toml", "mine");
  const ProgramResult result = run_floe(folder, "init a.toml");
  EXPECT_EQ(result.code, 9);
  EXPECT_EQ(result.error, "floe: error: a.toml: is there already (floe init overwrites nothing)\n");
  EXPECT_EQ(folder.read("a.toml"), "mine");
}

TEST(InitCommand, RefusesWhatCannotBe) {
  const TestFolder folder;
  const std::pair<const char*, int> table[] = {{"a.toml --thickness 0", 2},
                                               {"a.toml --sea 2", 2},
                                               {"a.toml --sea -1 6", 2},
                                               {"a.toml --heading 400", 2},
                                               {"a.toml --mesh none.msh", 4},
                                               {"a.toml --mesh a.msh --length 3", 2},
                                               {"none/a.toml", 7}};
  for (const auto& [arguments, code] : table)
    EXPECT_EQ(run_floe(folder, std::string("init ") + arguments).code, code) << arguments;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(InitCommand, ATitleIsOnlyText) {
  const TestFolder folder;
  ASSERT_EQ(run_floe(folder, "init '\"]x = 1.toml'").code, 0);
  EXPECT_EQ(run_floe(folder, "check '\"]x = 1.toml'").code, 0);
}

}  // namespace
}  // namespace floe
