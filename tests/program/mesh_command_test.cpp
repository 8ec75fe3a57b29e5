#include "floe_program.hpp"

#include <floe/mesh/mesh_file.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace floe {
namespace {

using test::kCaseText;
using test::ProgramResult;
using test::run_floe;
using test::TestFolder;
using test::with;
using testing::HasSubstr;
using testing::StartsWith;

struct ShapeExample {
  const char* words;  // of the command line
  const char* key;    // of [mesh]
  Index elements;
  Index nodes;
  int pieces;
};

// Elements and nodes counted by hand: a disc whose quarter arcs of 15.7 m are cut
// into 4 has a core of 4 × 4 and 2 layers of 16; a ring of 2π · 10 / 5 = 13 arcs; an L of 16 - 4;
// 6 modules of 4 × 2
constexpr ShapeExample kExamples[] = {
    {"rectangle --length 20 --width 10 --nx 4 --ny 2",
     "rectangle = { length = 20, width = 10, nx = 4, ny = 2 }", 8, 37, 1},
    {"disc --radius 10 --element-size 4", "disc = { radius = 10, element_size = 4 }", 48, 161, 1},
    {"ring --inner-radius 6 --outer-radius 10 --element-size 5",
     "ring = { inner_radius = 6, outer_radius = 10, element_size = 5 }", 13, 65, 1},
    {"lshape --length 20 --width 20 --cut-length 10 --cut-width 10 --element-size 5",
     "lshape = { length = 20, width = 20, cut_length = 10, cut_width = 10, element_size = 5 }", 12,
     53, 1},
    {"modules --module-length 20 --module-width 10 --modules-x 3 --modules-y 2 --gap 5 "
     "--element-size 5",
     "modules = { module_length = 20, module_width = 10, modules_x = 3, modules_y = 2, gap = 5, "
     "element_size = 5 }",
     48, 222, 6},
};

// The program's file, read again, and the key of the case file give the mesh that was told
TEST(MeshCommand, MakesEveryShapeAsAFileAndAsAKeyOfTheCase) {
  const TestFolder folder;
  for (const ShapeExample& example : kExamples) {
    const ProgramResult made = run_floe(folder, std::string("mesh ") + example.words + " -o a.msh");
    ASSERT_EQ(made.code, 0) << made.error;
    const std::string counts = std::to_string(example.nodes) + " nodes, " +
                               std::to_string(example.elements) + " elements, " +
                               std::to_string(example.pieces) + " piece";
    EXPECT_THAT(made.output, StartsWith("a.msh: " + counts));
    const mesh::MeshFile file = mesh::read_mesh(folder.path() / "a.msh");
    EXPECT_EQ(file.mesh.node_count(), example.nodes) << example.words;
    EXPECT_EQ(file.mesh.element_count(), example.elements) << example.words;
    EXPECT_EQ(file.mesh.piece_count(), example.pieces) << example.words;
    EXPECT_TRUE(file.notices.empty());
    for (const std::string mesh : {example.key, "file = \"a.msh\""}) {
      folder.write("case.toml",
                   with("rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }", mesh));
      const ProgramResult check = run_floe(folder, "check case.toml");
      EXPECT_EQ(check.code, 0) << mesh << check.error;
      EXPECT_THAT(check.output, HasSubstr(counts)) << mesh;
    }
  }
}

TEST(MeshCommand, RefusesSizesOfTheCaseWithThreeAndThePlace) {
  const TestFolder folder;
  const std::pair<const char*, const char*> table[] = {
      {"disc = { radius = -1, element_size = 4 }",
       "case.toml:9:19: invalid mesh.disc.radius = -1 m (must be positive)"},
      {"disc = { radius = 1 }", "mesh.disc.element_size"},
      {"disc = { radius = 1, elementsize = 4 }", "element_size"},
      {"disc = { radius = 1, element_size = 1 }\nfile = \"a.msh\"",
       "ambiguous mesh (must hold one of rectangle, disc, ring, lshape, modules, file)"},
      {"ring = { inner_radius = 2, outer_radius = 1, element_size = 1 }",
       "invalid ring inner_radius = 2 m (must be less than outer_radius = 1 m)"},
  };
  for (const auto& [mesh, message] : table) {
    folder.write("case.toml",
                 with("rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }", mesh));
    const ProgramResult result = run_floe(folder, "check case.toml");
    EXPECT_EQ(result.code, 3) << mesh;
    EXPECT_THAT(result.error, HasSubstr(message)) << mesh;
  }
}

TEST(MeshCommand, RunsACaseOnAShapeAndReportsIt) {
  const TestFolder folder;
  folder.write("case.toml", with("rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }",
                                 "ring = { inner_radius = 30, outer_radius = 50, element_size = "
                                 "25 }") +
                                "[modes]\ncount = 6\n");
  const ProgramResult run = run_floe(folder, "run case.toml");
  ASSERT_EQ(run.code, 0) << run.error;
  EXPECT_THAT(folder.read("case.out/run.json"), HasSubstr("\"inner_radius\""));
  const ProgramResult resumed = run_floe(folder, "run case.toml --resume");
  EXPECT_EQ(resumed.code, 0) << resumed.error;
}

}  // namespace
}  // namespace floe
