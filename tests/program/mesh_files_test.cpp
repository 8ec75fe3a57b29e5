#include "csv.hpp"
#include "floe_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace floe {
namespace {

using test::kCaseText;
using test::ProgramResult;
using test::run_floe;
using test::TestFolder;
using test::with;
using testing::AllOf;
using testing::HasSubstr;

const std::string kRectangle = "rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }";
const std::string kEnd =
    "[modes]\ncount = 6\n[output]\npoints = { P1 = [-150, -30], P5 = [0, 0] }\n";

// What floe writes for ParaView is a mesh again, whatever its name; coordinates are stored in
// double
TEST(MeshFiles, AreReadByTheirContentWhateverTheirName) {
  const TestFolder folder;
  folder.write("a.toml", kCaseText + kEnd);
  ASSERT_EQ(run_floe(folder, "run a.toml").code, 0);
  const auto field = std::filesystem::directory_iterator(folder.path() / "a.out/fields")->path();
  std::filesystem::copy_file(field, folder.path() / "plate.msh");
  folder.write("b.toml", with(kRectangle, "file = \"plate.msh\"") + kEnd);
  const ProgramResult run = run_floe(folder, "run b.toml");
  ASSERT_EQ(run.code, 0) << run.error;
  for (const char* column : {"re_w", "im_w"}) {
    const auto expected = test::read_csv(folder.path() / "a.out/rao_points.csv").numbers(column);
    const auto found = test::read_csv(folder.path() / "b.out/rao_points.csv").numbers(column);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9);
  }
}

TEST(MeshFiles, ThatAreNotReadAreRefusedByNameWithFour) {
  const TestFolder folder;
  folder.write("case.toml", with(kRectangle, "file = \"plate.vtu\"") + kEnd);
  const std::pair<std::string, std::string> table[] = {
      {"cylinder\n1.0 9.80665 ULEN GRAV\n0 0\n1\n0 0 -1 1 0 -1 1 1 -1 0 1 -1\n", "WAMIT .gdf"},
      {"2 0\n1 0 0 -1\n2 1 0 -1\n0 0. 0. 0.\n1 2 3 4\n", "NEMOH .dat"},
      {"  ------Hull Mesh File------\n\n # Number of Panels, Nodes\n 1 4 0 0\n", "HAMS .pnl"},
      {"MESH dimension 3 ElemType Quadrilateral Nnode 4\n", "GiD mesh"},
      {"$NOD\n1\n1 0 0 0\n$ENDNOD\n", "Gmsh MSH 1 mesh"},
      {"\x1f\x8b\x08", "gzip archive"},
      {"<VTKFile type=\"PolyData\"><PolyData/></VTKFile>", "VTK PolyData"},
      {std::string("$MeshFormat\n4.1 1 8\n\0\0\0\1\n$EndMeshFormat\n", 41), "big-endian binary"}};
  for (const auto& [content, name] : table) {
    folder.write("plate.vtu", content);
    for (const char* command : {"check", "run"}) {
      const ProgramResult result = run_floe(folder, std::string(command) + " case.toml");
      EXPECT_EQ(result.code, 4) << name;
      EXPECT_THAT(result.error, AllOf(HasSubstr("plate.vtu"), HasSubstr("found " + name)));
    }
  }
}

}  // namespace
}  // namespace floe
