#include "floe_program.hpp"

#include <floe/mesh/gmsh.hpp>

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
  Index elements;
  Index nodes;
  int pieces;
};

// Elements and nodes counted by hand: a disc whose quarter arcs of 15.7 m are cut
// into 4 has a core of 4 × 4 and 2 layers of 16; a ring of 2π · 10 / 5 = 13 arcs; an L of 16 - 4;
// 6 modules of 4 × 2
constexpr ShapeExample kExamples[] = {
    {"rectangle --length 20 --width 10 --nx 4 --ny 2", 8, 37, 1},
    {"disc --radius 10 --element-size 4", 48, 161, 1},
    {"ring --inner-radius 6 --outer-radius 10 --element-size 5", 13, 65, 1},
    {"lshape --length 20 --width 20 --cut-length 10 --cut-width 10 --element-size 5", 12, 53, 1},
    {"modules --module-length 20 --module-width 10 --modules-x 3 --modules-y 2 --gap 5 "
     "--element-size 5",
     48, 222, 6},
};

// The program's file, read again, gives the mesh that was told
TEST(MeshCommand, MakesEveryShapeAsAFile) {
  const TestFolder folder;
  for (const ShapeExample& example : kExamples) {
    const ProgramResult made = run_floe(folder, std::string("mesh ") + example.words + " -o a.msh");
    ASSERT_EQ(made.code, 0) << made.error;
    const std::string counts = std::to_string(example.nodes) + " nodes, " +
                               std::to_string(example.elements) + " elements, " +
                               std::to_string(example.pieces) + " piece";
    EXPECT_THAT(made.output, StartsWith("a.msh: " + counts));
    const mesh::MeshFile file = mesh::read_gmsh(folder.path() / "a.msh");
    EXPECT_EQ(file.mesh.node_count(), example.nodes) << example.words;
    EXPECT_EQ(file.mesh.element_count(), example.elements) << example.words;
    EXPECT_EQ(file.mesh.piece_count(), example.pieces) << example.words;
    EXPECT_TRUE(file.notices.empty());
    for (const std::string mesh : {"file = \"a.msh\""}) {
      folder.write("case.toml",
                   with("rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }", mesh));
      const ProgramResult check = run_floe(folder, "check case.toml");
      EXPECT_EQ(check.code, 0) << mesh << check.error;
      EXPECT_THAT(check.output, HasSubstr(counts)) << mesh;
    }
  }
}

}  // namespace
}  // namespace floe
