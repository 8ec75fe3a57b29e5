#include "mesh/gmsh_content.hpp"
#include "tiny_meshes.hpp"

#include <floe/mesh/gmsh.hpp>
#include <floe/numeric/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <clocale>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace floe::mesh {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

std::filesystem::path data_file(const std::string& name) {
  return std::filesystem::path(FLOE_TEST_DATA) / "mesh" / name;
}

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

// The message of the MeshError that the bytes give; "" if they are a mesh
std::string error_of(const std::string& bytes) {
  try {
    read_gmsh_bytes(bytes, "a.msh");
  } catch (const MeshError& error) {
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}

// A square of one element with 8 nodes, as MSH 2.2; node and element lines can be added to
std::string square_22(const std::string& more_nodes = "", int more_node_count = 0,
                      const std::string& more_elements = "", int more_element_count = 0) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(8 + more_node_count) +
         "\n1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 2 0\n5 1 0 0\n6 2 1 0\n7 1 2 0\n8 0 1 0\n" + more_nodes +
         "$EndNodes\n$Elements\n" + std::to_string(1 + more_element_count) +
         "\n1 16 2 0 1 1 2 3 4 5 6 7 8\n" + more_elements + "$EndElements\n";
}

// The same as MSH 4.1
std::string square_41() {
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n2 8 1 8\n0 1 0 4\n1\n2\n3\n4\n0 0 0\n2 0 "
         "0\n"
         "2 2 0\n0 2 0\n2 1 0 4\n5\n6\n7\n8\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n$EndNodes\n"
         "$Elements\n1 1 1 1\n2 1 16 1\n1 1 2 3 4 5 6 7 8\n$EndElements\n";
}

const std::vector<std::string>& every_file() {
  static const std::vector<std::string> names = {
      "sector_quad8_22.msh",          "sector_quad8_22_bin.msh", "sector_quad8_41.msh",
      "sector_quad8_41_bin.msh",      "sector_quad9_22.msh",     "sector_quad9_22_bin.msh",
      "sector_quad9_41.msh",          "sector_quad9_41_bin.msh", "sector_parametric_41.msh",
      "sector_parametric_41_bin.msh", "sector_quad4_22.msh",     "sector_quad4_22_bin.msh",
      "sector_quad4_41.msh",          "sector_quad4_41_bin.msh"};
  return names;
}

bool is_linear(const std::string& name) { return name.find("quad4") != std::string::npos; }

// ASCII files carry 16 digits: 4 m to 2^-52 · 4 m either way
TEST(Gmsh, EveryDialectGivesTheSameMesh) {
  const Q8Mesh reference = read_gmsh(data_file(every_file()[0])).mesh;
  EXPECT_EQ(reference.element_count(), 4);
  EXPECT_EQ(reference.node_count(), 23);
  for (const std::string& name : every_file()) {
    const Q8Mesh mesh = read_gmsh(data_file(name)).mesh;
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
    const Q8Mesh mesh = read_gmsh(data_file(name)).mesh;
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
  EXPECT_THAT(read_gmsh(data_file("sector_quad8_41.msh")).notices, ElementsAre(dropped));
  EXPECT_THAT(read_gmsh(data_file("sector_quad9_22_bin.msh")).notices,
              ElementsAre(dropped, HasSubstr("dropped 4 centre nodes")));
  EXPECT_THAT(read_gmsh(data_file("sector_quad4_22.msh")).notices,
              ElementsAre(dropped, HasSubstr("gave mid-side nodes to 4 quadrilaterals")));
  EXPECT_TRUE(read_gmsh_bytes(square_22(), "a.msh").notices.empty());
}

TEST(Gmsh, ReadsASquareInBothVersions) {
  for (const std::string& text : {square_22(), square_41()}) {
    const Q8Mesh mesh = read_gmsh_bytes(text, "a.msh").mesh;
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
    EXPECT_EQ(read_gmsh_bytes(text, "a.msh").mesh.nodes()(0, 4), 1.0000000001);
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
  const Q8Mesh mesh = read_gmsh_bytes(text, "a.msh").mesh;
  EXPECT_EQ(mesh.element_nodes(1).col(7), Point2(2.2, 1.0));
  EXPECT_EQ(mesh.node_count(), 13);
}

TEST(Gmsh, ChecksForCoincidentNodesOnlyAmongThoseOfQuads) {
  EXPECT_EQ(error_of(square_22("9 0 0 0\n10 1 1 0\n", 2, "2 15 2 0 1 9\n", 1)), "");
}

TEST(Gmsh, RefusesTrianglesAndVolumesByNameWithTheirCount) {
  const std::string text =
      square_22("", 0, "2 2 2 0 1 1 2 3\n3 2 2 0 1 1 3 4\n4 5 2 0 1 1 2 3 4 5 6 7 8\n", 3);
  EXPECT_THAT(error_of(text),
              AllOf(HasSubstr("a.msh: invalid elements = "), HasSubstr("2 triangles with 3 nodes"),
                    HasSubstr("1 hexahedra with 8 nodes")));
}

TEST(Gmsh, RefusesAFileWithoutQuads) {
  const std::string text = replaced(square_22(), "1 16 2 0 1 1 2 3 4 5 6 7 8", "1 1 2 0 1 1 2");
  EXPECT_THAT(error_of(text), AllOf(HasSubstr("quadrilaterals = 0"), HasSubstr("1 line element")));
}

TEST(Gmsh, RefusesAMeshOffTheWaterPlane) {
  std::string shifted = square_41();
  for (const char* xy :
       {"\n0 0 ", "\n2 0 ", "\n2 2 ", "\n0 2 ", "\n1 0 ", "\n2 1 ", "\n1 2 ", "\n0 1 "})
    shifted = replaced(shifted, std::string(xy) + "0\n", std::string(xy) + "-1.5\n");
  EXPECT_THAT(error_of(shifted), AllOf(HasSubstr("invalid z = -1.5 to -1.5 m"),
                                       HasSubstr("shift the mesh to the water plane")));
  EXPECT_THAT(error_of(replaced(square_22(), "7 1 2 0", "7 1 2 0.1")),
              AllOf(HasSubstr("invalid z = 0 to 0.1 m"), HasSubstr("turn and shift")));
}

TEST(Gmsh, AcceptsZWithinTheTolerance) {
  EXPECT_EQ(error_of(replaced(square_22(), "7 1 2 0", "7 1 2 1.9e-6")), "");
  EXPECT_THAT(error_of(replaced(square_22(), "7 1 2 0", "7 1 2 2.1e-6")), HasSubstr("invalid z"));
}

TEST(Gmsh, PassesOnWhatTheMeshRefuses) {
  EXPECT_THAT(error_of(replaced(square_22(), "1 2 3 4 5 6 7 8\n$", "1 3 2 4 5 6 7 8\n$")),
              AllOf(HasSubstr("a.msh: invalid mesh: "), HasSubstr("element 1")));
}

TEST(Gmsh, NamesTheLineOfABadNumber) {
  EXPECT_THAT(error_of(replaced(square_22(), "6 2 1 0", "6 2 one 0")),
              HasSubstr("a.msh:11: invalid coordinate y = 'one' (must be a finite number)"));
  EXPECT_THAT(error_of(replaced(square_22(), "6 2 1 0", "6 2 1,0 0")),
              HasSubstr("a.msh:11: invalid coordinate y = '1,0'"));
  for (const char* bad : {"nan", "inf", "-inf", "1e400", "0x10", "1.0D+00", "1..0", "--1"})
    EXPECT_THAT(error_of(replaced(square_22(), "6 2 1 0", std::string("6 2 ") + bad + " 0")),
                HasSubstr("a.msh:11: invalid coordinate y"))
        << bad;
  EXPECT_THAT(error_of(replaced(square_22(), "6 2 1 0", "6.5 2 1 0")),
              HasSubstr("a.msh:11: invalid node tag = '6.5' (must be an integer)"));
}

TEST(Gmsh, RefusesBadNodeTags) {
  EXPECT_THAT(error_of(replaced(square_22(), "6 2 1 0", "0 2 1 0")),
              HasSubstr("a.msh:11: invalid node tag = 0 (must be positive)"));
  EXPECT_THAT(error_of(replaced(square_22(), "6 2 1 0", "-6 2 1 0")), HasSubstr("node tag = -6"));
  EXPECT_THAT(error_of(replaced(square_22(), "6 2 1 0", "5 2 1 0")),
              HasSubstr("node tag = 5 (must stand once)"));
  for (const char* tag : {"0", "-1", "9", "4611686018427387904"})
    EXPECT_THAT(error_of(replaced(square_22(), "5 6 7 8\n$", std::string("5 6 7 ") + tag + "\n$")),
                AllOf(HasSubstr("a.msh:17: invalid node tag = "), HasSubstr("one of $Nodes")));
  EXPECT_THAT(error_of(replaced(square_41(), "6\n7\n8\n", "6\n7\n18446744073709551615\n")),
              HasSubstr("invalid node tag"));
}

// Every count of the two texts, too large, negative, beyond 64 bits
TEST(Gmsh, RefusesCountsThatDoNotFit) {
  for (const char* bad : {"9", "7", "-1", "4000000000", "9223372036854775807",
                          "9223372036854775808", "99999999999999999999", "x"}) {
    const std::string value(bad);
    EXPECT_NE(error_of(replaced(square_22(), "\n8\n1 0", "\n" + value + "\n1 0")), "") << bad;
    EXPECT_NE(error_of(replaced(square_22(), "\n1\n1 16", "\n" + value + "\n1 16")), "") << bad;
    EXPECT_NE(error_of(replaced(square_22(), "1 16 2 0", "1 16 " + value + " 0")), "") << bad;
    EXPECT_NE(error_of(replaced(square_41(), "2 8 1 8", value + " 8 1 8")), "") << bad;
    EXPECT_NE(error_of(replaced(square_41(), "2 8 1 8", "2 " + value + " 1 8")), "") << bad;
    EXPECT_NE(error_of(replaced(square_41(), "0 1 0 4", "0 1 0 " + value)), "") << bad;
    EXPECT_NE(error_of(replaced(square_41(), "1 1 1 1", value + " 1 1 1")), "") << bad;
    EXPECT_NE(error_of(replaced(square_41(), "1 1 1 1", "1 " + value + " 1 1")), "") << bad;
    EXPECT_NE(error_of(replaced(square_41(), "2 1 16 1", "2 1 16 " + value)), "") << bad;
  }
  EXPECT_THAT(error_of(replaced(square_22(), "\n8\n1 0", "\n4000000000\n1 0")),
              AllOf(HasSubstr("a.msh:5: invalid node count = 4000000000"),
                    HasSubstr("no more fit in the file")));
}

TEST(Gmsh, RefusesBadFlagsAndTypes) {
  EXPECT_THAT(error_of(replaced(square_41(), "0 1 0 4", "4 1 0 4")), HasSubstr("entity dimension"));
  EXPECT_THAT(error_of(replaced(square_41(), "0 1 0 4", "0 1 2 4")), HasSubstr("parametric flag"));
  EXPECT_THAT(error_of(replaced(square_41(), "2 1 16 1", "2 1 999 1")),
              HasSubstr("invalid element type = 999"));
  EXPECT_THAT(error_of(replaced(square_22(), "2.2 0 8", "2.2 2 8")), HasSubstr("file type = 2"));
  EXPECT_THAT(error_of(replaced(square_22(), "2.2 0 8", "2.2 0 4")), HasSubstr("data size = 4"));
}

TEST(Gmsh, RefusesSectionsInDisorder) {
  const std::string text = square_22();
  const std::size_t nodes = text.find("$Nodes"), elements = text.find("$Elements");
  const std::string head = text.substr(0, nodes);
  const std::string node_part = text.substr(nodes, elements - nodes), rest = text.substr(elements);
  EXPECT_THAT(error_of(node_part + rest), HasSubstr("$Nodes without $MeshFormat"));
  EXPECT_THAT(error_of(head + rest + node_part), HasSubstr("$Elements before $Nodes"));
  EXPECT_THAT(error_of(head + node_part + node_part + rest), HasSubstr("a second $Nodes"));
  EXPECT_THAT(error_of(head + node_part + rest + rest), HasSubstr("a second $Elements"));
  EXPECT_THAT(error_of(head + head + node_part + rest), HasSubstr("a second $MeshFormat"));
  EXPECT_THAT(error_of(head + node_part), HasSubstr("no section $Elements"));
  EXPECT_THAT(error_of(head), HasSubstr("no section $Nodes"));
  EXPECT_THAT(error_of(text + "trailing junk"), HasSubstr("a.msh:19: found 'trailing'"));
  EXPECT_THAT(error_of(replaced(text, "$EndNodes", "$EndNods")),
              HasSubstr("a.msh:14: found '$EndNods' (must be $EndNodes)"));
  EXPECT_THAT(error_of(head + "$ParametricNodes\n0\n$EndParametricNodes\n"),
              HasSubstr("found $ParametricNodes"));
}

TEST(Gmsh, NamesWhatItFindsInstead) {
  const auto expect = [](const std::string& bytes, const std::string& name) {
    EXPECT_THAT(error_of(bytes), AllOf(HasSubstr("a.msh"), HasSubstr("found " + name)));
  };
  expect("", "empty file");
  expect("\x1f\x8b\x08 rest", "gzip archive");
  expect("PK\x03\x04 rest", "zip archive");
  expect("$NOD\n4\n1 0 0 0\n", "Gmsh MSH 1 mesh");
  expect("$MeshFormat\n1.0 0 8\n", "Gmsh MSH 1.0");
  expect("$MeshFormat\n3 0 8\n$EndMeshFormat\n", "Gmsh MSH 3");
  expect("$MeshFormat\n4 0 8\n$EndMeshFormat\n", "Gmsh MSH 4 ");
  expect("$MeshFormat\n4.0 0 8\n$EndMeshFormat\n", "Gmsh MSH 4.0");
  expect("MESH \"plate\" dimension 3 ElemType Quadrilateral Nnode 4\n", "GiD mesh");
  expect("# GiD\nmesh dimension = 3\n", "GiD mesh");
  expect("JOB AQWA  LINE\nTITLE  barge\n", "AQWA input file");
  expect("* comment\n**\nJOB MESH  LIN\n", "AQWA input file");
  expect("<?xml version=\"1.0\"?>\n<VTKFile>", "XML file");
  expect("# vtk DataFile Version 3.0\n", "VTK file");
  expect("1.0 2.0 3.0\n", "file of unknown format");
  expect(std::string(1000, '\0'), "file of unknown format");
}

TEST(Gmsh, NamesBigEndianBinary) {
  EXPECT_THAT(error_of(std::string("$MeshFormat\n4.1 1 8\n\0\0\0\1\n$EndMeshFormat\n", 41)),
              HasSubstr("found big-endian binary"));
  EXPECT_THAT(error_of(std::string("$MeshFormat\n2.2 1 8\n\7\0\0\0\n$EndMeshFormat\n", 41)),
              HasSubstr("mark of the byte order = 7"));
}

// All but the last line's end can be missed
TEST(Gmsh, RefusesEveryTruncation) {
  for (const std::string& name : every_file()) {
    const std::string bytes = bytes_of(data_file(name));
    const std::size_t end = bytes.rfind("$EndElements") + std::string("$EndElements").size();
    ASSERT_LE(end, bytes.size());
    for (std::size_t length = 0; length < end; ++length)
      ASSERT_THAT(error_of(bytes.substr(0, length)), HasSubstr("a.msh")) << name << " " << length;
    EXPECT_EQ(error_of(bytes.substr(0, end)), "") << name;
  }
}

// A spoilt byte makes another mesh or a MeshError; another exception would end the test
TEST(Gmsh, SurvivesEverySpoiltByte) {
  for (const char* name : {"sector_quad8_22.msh", "sector_quad8_22_bin.msh", "sector_quad4_41.msh",
                           "sector_parametric_41_bin.msh"}) {
    const std::string bytes = bytes_of(data_file(name));
    for (std::size_t i = 0; i < bytes.size(); ++i)
      for (const char by : {'\0', '\xff', '\x7f', '9', '-', '\n'}) {
        std::string spoilt = bytes;
        spoilt[i] = by;
        ASSERT_NO_THROW(error_of(spoilt)) << name << " " << i;
      }
  }
}

TEST_F(GmshFile, RoundTripsToTheLastBit) {
  test::MeshArrays arrays = test::ring_arrays(std::numbers::pi, 10.0 / 3.0, 24, 2);
  arrays.nodes(0, 5) += 1e-15;
  const Q8Mesh mesh = test::joined(arrays, test::rectangle_arrays(2, 2, 0.1, 0.3)).build();
  write_gmsh(folder_ / "ring.msh", mesh);
  const MeshFile read = read_gmsh(folder_ / "ring.msh");
  EXPECT_EQ(read.mesh.nodes(), mesh.nodes());
  EXPECT_EQ(read.mesh.elements(), mesh.elements());
  EXPECT_TRUE(read.notices.empty());
  EXPECT_THAT(bytes_of(folder_ / "ring.msh"), HasSubstr("2 1 \"plate\""));
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
  EXPECT_EQ(read_gmsh(folder_ / "link.msh").mesh.element_count(), 12);
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
      read_gmsh(path);
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
  EXPECT_EQ(read_gmsh(path).mesh.element_count(), 1);
}

// Areas from the shapes: parabolas in place of arcs miss φ⁴/480 of a disc's area (see Q8Mesh tests)
TEST(Gmsh, ReadsTheMeshesThatComeWithTheProgram) {
  const std::filesystem::path folder = std::filesystem::path(FLOE_SOURCE_DIR) / "meshes";
  const double pi = std::numbers::pi;
  const auto missing = [&](int edges) { return std::pow(2.0 * pi / edges, 4) / 480.0; };
  const auto expect = [&](const char* name, Index elements, double area, double error) {
    const MeshFile file = read_gmsh(folder / name);
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
