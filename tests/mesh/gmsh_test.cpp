#include "gmsh_texts.hpp"
#include "test_paths.hpp"
#include "tiny_meshes.hpp"

#include <floe/mesh/gmsh.hpp>
#include <floe/mesh/mesh_file.hpp>
#include <floe/numeric/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <clocale>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace floe::mesh {
namespace {

using test::bytes_of;
using test::data_file;
using test::error_of;
using test::every_file;
using test::replaced;
using test::square_22;
using test::square_41;
using testing::ElementsAre;
using testing::HasSubstr;

// An empty folder of its own for each test, removed at the end
class GmshFile : public testing::Test {
 protected:
  GmshFile()
      : folder_(std::filesystem::temp_directory_path() /
                ("floe_gmsh_test_" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directory(folder_);
  }
  ~GmshFile() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  std::filesystem::path folder_;
};

bool is_linear(const std::string& name) { return name.find("quad4") != std::string::npos; }

// ASCII files carry 16 digits: 4 m to 2^-52 · 4 m either way
TEST(Gmsh, EveryDialectGivesTheSameMesh) {
  const Q8Mesh reference = read_mesh(data_file(every_file()[0])).mesh;
  EXPECT_EQ(reference.element_count(), 4);
  EXPECT_EQ(reference.node_count(), 23);
  for (const std::string& name : every_file()) {
    const Q8Mesh mesh = read_mesh(data_file(name)).mesh;
    ASSERT_EQ(mesh.element_count(), 4) << name;
    ASSERT_EQ(mesh.node_count(), 23) << name;
    const int compared = is_linear(name) ? 4 : 8;
    for (Index e = 0; e < 4; ++e) {
      const Eigen::Matrix<double, 2, 8> difference =
          mesh.element_nodes(e) - reference.element_nodes(e);
      EXPECT_LE(difference.leftCols(compared).cwiseAbs().maxCoeff(), 1e-15) << name << " " << e;
    }
  }
}

TEST(Gmsh, RaisesFourNodesWithSharedStraightMidSides) {
  for (const std::string& name : every_file()) {
    if (!is_linear(name)) continue;
    const Q8Mesh mesh = read_mesh(data_file(name)).mesh;
    EXPECT_EQ(mesh.node_count(), 23) << name;  // 10 corners and 13 edges
    for (Index e = 0; e < mesh.element_count(); ++e) {
      const Eigen::Matrix<double, 2, 8> points = mesh.element_nodes(e);
      for (int side = 0; side < 4; ++side)
        EXPECT_EQ(points.col(4 + side), 0.5 * (points.col(side) + points.col((side + 1) % 4)));
    }
  }
}

TEST(Gmsh, TellsWhatItDropsInOneNotice) {
  const auto dropped =
      HasSubstr("dropped 7 point elements, 11 line elements and 1 node that no quadrilateral uses");
  EXPECT_THAT(read_mesh(data_file("sector_quad8_41.msh")).notices, ElementsAre(dropped));
  EXPECT_THAT(read_mesh(data_file("sector_quad9_22_bin.msh")).notices,
              ElementsAre(dropped, HasSubstr("dropped 4 centre nodes")));
  EXPECT_THAT(read_mesh(data_file("sector_quad4_22.msh")).notices,
              ElementsAre(dropped, HasSubstr("gave mid-side nodes to 4 quadrilaterals")));
  EXPECT_TRUE(read_mesh_bytes(square_22(), "a.msh").notices.empty());
}

TEST(Gmsh, ReadsASquareInBothVersions) {
  for (const std::string& text : {square_22(), square_41()}) {
    const Q8Mesh mesh = read_mesh_bytes(text, "a.msh").mesh;
    EXPECT_EQ(mesh.node_count(), 8);
    EXPECT_DOUBLE_EQ(mesh.area(), 4.0);
  }
}

TEST(Gmsh, AcceptsWindowsLinesTabsBlanksAndAByteOrderMark) {
  for (const std::string& text : {square_22(), square_41()}) {
    std::string odd = "\xef\xbb\xbf";
    for (const char c : text) {
      if (c == '\n') odd += " \r\n\r";
      odd += c == ' ' ? '\t' : c;
    }
    EXPECT_EQ(error_of(odd), "");
  }
}

TEST(Gmsh, ReadsNumbersInEveryLocale) {
  const std::string text = replaced(square_22(), "5 1 0 0", "5 1.0000000001e+0 +0. -0.0");
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"}) {
    std::setlocale(LC_ALL, locale);  // not every machine has them
    EXPECT_EQ(read_mesh_bytes(text, "a.msh").mesh.nodes()(0, 4), 1.0000000001);
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Gmsh, SkipsSectionsItDoesNotNeed) {
  const std::string extra =
      "$Comments\nanything $EndNodes \"at\" all\n$EndComments\n$PhysicalNames\n1\n2 1 \"plate\"\n"
      "$EndPhysicalNames\n";
  EXPECT_EQ(error_of(extra + square_22() + "$NodeData\n1\n$EndNodeData\n"), "");
  EXPECT_EQ(error_of(extra + square_41()), "");
}

TEST(Gmsh, AcceptsGapsBetweenTags) {
  const std::string far = std::to_string(std::int64_t{1} << 62);
  std::string text = square_41();
  text = replaced(text, "5\n6\n7\n8\n", far + "\n6\n7\n8\n");
  text = replaced(text, "4 5 6 7 8", "4 " + far + " 6 7 8");
  EXPECT_EQ(error_of(text), "");
}

TEST(Gmsh, TakesTheMidSideNodeOfAQuadraticNeighbour) {
  // A 4-node quad to the right of a square whose right-hand edge is bent
  std::string text = square_22("9 4 0 0\n10 4 2 0\n", 2, "2 3 2 0 1 2 9 10 3\n", 1);
  text = replaced(text, "6 2 1 0", "6 2.2 1 0");
  const Q8Mesh mesh = read_mesh_bytes(text, "a.msh").mesh;
  EXPECT_EQ(mesh.element_nodes(1).col(7), Point2(2.2, 1.0));
  EXPECT_EQ(mesh.node_count(), 13);
}

TEST(Gmsh, ChecksForCoincidentNodesOnlyAmongThoseOfQuads) {
  EXPECT_EQ(error_of(square_22("9 0 0 0\n10 1 1 0\n", 2, "2 15 2 0 1 9\n", 1)), "");
}

TEST_F(GmshFile, RoundTripsToTheLastBit) {
  test::MeshArrays arrays = test::ring_arrays(std::numbers::pi, 10.0 / 3.0, 24, 2);
  arrays.nodes(0, 5) += 1e-15;
  const Q8Mesh mesh = test::joined(arrays, test::rectangle_arrays(2, 2, 0.1, 0.3)).build();
  write_gmsh(folder_ / "ring.msh", mesh);
  const MeshFile read = read_mesh(folder_ / "ring.msh");
  EXPECT_EQ(read.mesh.nodes(), mesh.nodes());
  EXPECT_EQ(read.mesh.elements(), mesh.elements());
  EXPECT_TRUE(read.notices.empty());
  EXPECT_THAT(bytes_of(folder_ / "ring.msh"), HasSubstr("2 1 \"plate\""));
}

TEST_F(GmshFile, KeepsGroupsAndWhatTheyLeaveOver) {
  write_gmsh(folder_ / "a.msh", test::tiny_plate(), {{"edge", {0, 5, 7}}, {"plate", {2}}});
  const MeshFile read = read_mesh(folder_ / "a.msh");
  const std::vector<std::pair<std::string, Index>> expected = {
      {"edge", 3}, {"plate", 1}, {"rest of plate", 8}};
  ASSERT_EQ(read.groups.size(), expected.size());
  for (const auto& [name, count] : expected) {
    const auto group =
        std::find_if(read.groups.begin(), read.groups.end(),
                     [&, wanted = name](const ElementGroup& g) { return g.name == wanted; });
    ASSERT_NE(group, read.groups.end()) << name;
    EXPECT_EQ(std::ssize(group->elements), count) << name;
    if (name != "edge") continue;
    EXPECT_EQ(read.mesh.element_nodes(group->elements[1]), test::tiny_plate().element_nodes(5));
  }
}

TEST_F(GmshFile, WritesTheSameBytesTwice) {
  write_gmsh(folder_ / "a.msh", test::tiny_plate());
  write_gmsh(folder_ / "b.msh", test::tiny_plate());
  EXPECT_EQ(bytes_of(folder_ / "a.msh"), bytes_of(folder_ / "b.msh"));
  const auto files = std::filesystem::directory_iterator(folder_);
  EXPECT_EQ(std::distance(begin(files), end(files)), 2);  // no temporary file is left
}

TEST_F(GmshFile, ReplacesALinkAndLeavesItsTarget) {
  write("target", "precious");
  std::filesystem::create_symlink(folder_ / "target", folder_ / "link.msh");
  write_gmsh(folder_ / "link.msh", test::tiny_plate());
  EXPECT_EQ(bytes_of(folder_ / "target"), "precious");
  EXPECT_EQ(read_mesh(folder_ / "link.msh").mesh.element_count(), 12);
}

TEST_F(GmshFile, ReportsAFileThatCannotBeWritten) {
  EXPECT_THROW(write_gmsh(folder_ / "none" / "a.msh", test::tiny_plate()), FileError);
  if (std::filesystem::exists("/dev/full")) {
    EXPECT_THROW(write_gmsh("/dev/full", test::tiny_plate()), FileError);
  }
}

TEST_F(GmshFile, NamesAMissingFileADirectoryAndAPipe) {
  const auto error_of_path = [](const std::filesystem::path& path) -> std::string {
    try {
      read_mesh(path);
    } catch (const MeshError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(error_of_path(folder_ / "none.msh"), HasSubstr("No such file"));
  EXPECT_THAT(error_of_path(folder_), HasSubstr("found a directory"));
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(error_of_path(folder_ / "pipe"), HasSubstr("found a pipe"));
  EXPECT_THAT(error_of_path("/dev/null"), HasSubstr("found a device"));
}

TEST_F(GmshFile, ReadsPathsWithBlanksAndOddLetters) {
  const auto path = write("-ü ñ é 橋.msh", square_22());
  EXPECT_EQ(read_mesh(path).mesh.element_count(), 1);
}

// Areas from the shapes: parabolas in place of arcs miss φ⁴/480 of a disc's area (see Q8Mesh tests)
TEST(Gmsh, ReadsTheMeshesThatComeWithTheProgram) {
  const std::filesystem::path folder = std::filesystem::path(FLOE_SOURCE_DIR) / "meshes";
  const double pi = std::numbers::pi;
  const auto missing = [&](int edges) { return std::pow(2.0 * pi / edges, 4) / 480.0; };
  const auto expect = [&](const char* name, Index elements, double area, double error) {
    const MeshFile file = read_mesh(folder / name);
    EXPECT_EQ(file.mesh.element_count(), elements) << name;
    EXPECT_NEAR(file.mesh.area(), area, 1.1 * error + 1e-9 * area) << name;
    EXPECT_EQ(file.mesh.piece_count(), 1) << name;
  };
  expect("disc.msh", 256, pi * 2500.0, pi * 2500.0 * missing(32));
  expect("lshape.msh", 288, 7200.0, 0.0);
  expect("ring.msh", 192, pi * 1600.0, pi * 1600.0 * missing(48));
  expect("plate_with_hole.msh", 356, 6000.0 - pi * 100.0, pi * 100.0 * missing(8));
}

}  // namespace
}  // namespace floe::mesh
