#include "gmsh_texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace floe::mesh {
namespace {

using test::bytes_of;
using test::data_file;
using test::error_of;
using test::every_file;
using test::replaced;
using test::square_22;
using test::square_41;
using testing::AllOf;
using testing::HasSubstr;

TEST(GmshErrors, RefusesTrianglesAndVolumesByNameWithTheirCount) {
  const std::string text =
      square_22("", 0, "2 2 2 0 1 1 2 3\n3 2 2 0 1 1 3 4\n4 5 2 0 1 1 2 3 4 5 6 7 8\n", 3);
  EXPECT_THAT(error_of(text),
              AllOf(HasSubstr("a.msh: invalid elements = "), HasSubstr("2 triangles with 3 nodes"),
                    HasSubstr("1 hexahedra with 8 nodes")));
}

TEST(GmshErrors, RefusesAFileWithoutQuads) {
  const std::string text = replaced(square_22(), "1 16 2 0 1 1 2 3 4 5 6 7 8", "1 1 2 0 1 1 2");
  EXPECT_THAT(error_of(text), AllOf(HasSubstr("quadrilaterals = 0"), HasSubstr("1 line element")));
}

TEST(GmshErrors, RefusesAMeshOffTheWaterPlane) {
  std::string shifted = square_41();
  for (const char* xy :
       {"\n0 0 ", "\n2 0 ", "\n2 2 ", "\n0 2 ", "\n1 0 ", "\n2 1 ", "\n1 2 ", "\n0 1 "})
    shifted = replaced(shifted, std::string(xy) + "0\n", std::string(xy) + "-1.5\n");
  EXPECT_THAT(error_of(shifted), AllOf(HasSubstr("invalid z = -1.5 to -1.5 m"),
                                       HasSubstr("shift the mesh to the water plane")));
  EXPECT_THAT(error_of(replaced(square_22(), "7 1 2 0", "7 1 2 0.1")),
              AllOf(HasSubstr("invalid z = 0 to 0.1 m"), HasSubstr("turn and shift")));
}

TEST(GmshErrors, AcceptsZWithinTheTolerance) {
  EXPECT_EQ(error_of(replaced(square_22(), "7 1 2 0", "7 1 2 1.9e-6")), "");
  EXPECT_THAT(error_of(replaced(square_22(), "7 1 2 0", "7 1 2 2.1e-6")), HasSubstr("invalid z"));
}

TEST(GmshErrors, PassesOnWhatTheMeshRefuses) {
  EXPECT_THAT(error_of(replaced(square_22(), "1 2 3 4 5 6 7 8\n$", "1 3 2 4 5 6 7 8\n$")),
              AllOf(HasSubstr("a.msh: invalid mesh: "), HasSubstr("element 1")));
}

// The corner 2 of the square has the tag 72 here, the element 900
TEST(GmshErrors, NamesNodesAndElementsByTheirTags) {
  std::string text = replaced(square_22(), "\n2 2 0 0\n", "\n72 2 0 0\n");
  text = replaced(text, "1 16 2 0 1 1 2 3 4 5 6 7 8", "900 16 2 0 1 1 72 3 4 5 6 7 8");
  EXPECT_EQ(error_of(text), "");
  EXPECT_THAT(error_of(replaced(text, "1 72 3 4 5", "1 3 72 4 5")),
              AllOf(HasSubstr("a.msh: invalid mesh: "), HasSubstr("element 900 at ")));
  EXPECT_THAT(error_of(replaced(text, "1 72 3 4 5", "1 72 72 4 5")),
              HasSubstr("element 900 has node 72 twice"));
}

TEST(GmshErrors, NamesTheLineOfABadNumber) {
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

TEST(GmshErrors, RefusesBadNodeTags) {
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
TEST(GmshErrors, RefusesCountsThatDoNotFit) {
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

TEST(GmshErrors, RefusesBlocksLargerThanTheWhole) {
  EXPECT_THAT(error_of(replaced(square_41(), "0 1 0 4", "0 1 0 9")),
              HasSubstr("a.msh:6: invalid nodes in block = 9 (must be at most 8)"));
  EXPECT_THAT(error_of(replaced(square_41(), "2 1 16 1", "2 1 16 2")),
              HasSubstr("a.msh:27: invalid elements in block = 2 (must be at most 1)"));
  // The first block of the binary file: type 15, one point
  const std::string head = "$Elements\n22\n\x0f";
  const std::string bytes = bytes_of(data_file("sector_quad8_22_bin.msh"));
  const std::size_t count = bytes.find(head) + head.size() + 3;
  ASSERT_EQ(bytes[count], '\1');
  std::string spoilt = bytes;
  spoilt[count] = 23;
  EXPECT_THAT(error_of(spoilt), HasSubstr("invalid elements in block = 23 (must be 1 to 22)"));
}

TEST(GmshErrors, RefusesBadFlagsAndTypes) {
  EXPECT_THAT(error_of(replaced(square_41(), "0 1 0 4", "4 1 0 4")), HasSubstr("entity dimension"));
  EXPECT_THAT(error_of(replaced(square_41(), "0 1 0 4", "0 1 2 4")), HasSubstr("parametric flag"));
  EXPECT_THAT(error_of(replaced(square_41(), "2 1 16 1", "2 1 999 1")),
              HasSubstr("invalid element type = 999"));
  EXPECT_THAT(error_of(replaced(square_22(), "2.2 0 8", "2.2 2 8")), HasSubstr("file type = 2"));
  EXPECT_THAT(error_of(replaced(square_22(), "2.2 0 8", "2.2 0 4")), HasSubstr("data size = 4"));
}

TEST(GmshErrors, RefusesSectionsInDisorder) {
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

TEST(GmshErrors, NamesWhatItFindsInstead) {
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
  expect("<?xml version=\"1.0\"?>\n<html>", "XML file");
  expect("# vtk DataFile Version 3.0\n", "VTK legacy file");
  expect("1.0 2.0 3.0\n", "file of unknown format");
  expect(std::string(1000, '\0'), "file of unknown format");
}

// The first lines of such files, as their manuals have them
TEST(GmshErrors, NamesPanelMeshesOfHullsWithAdvice) {
  const std::string wamit =
      "Cylinder R=1 T=0.5\n1.000000 9.80665 ULEN GRAV\n1 1 ISX ISY\n256\n"
      "0.0 0.0 -0.5 0.1 0.0 -0.5 0.1 0.1 -0.5 0.0 0.1 -0.5\n";
  const std::string higher_order = "ellipsoid\n1.0 9.8\n1 1\n4 0\n3 3\n4 4\n";
  const std::string nemoh =
      "    2    1\n     1    5.0    0.0   0.0\n     2    4.9    0.8   0.0\n0 0. 0. 0.\n1 2 3 4\n";
  const std::string hams =
      "    --------------Hull Mesh File---------------\n\n    # Number of Panels, Nodes, "
      "X-Symmetry "
      "and Y-Symmetry\n         300         341         0         0\n";
  for (const auto& [bytes, name] : {std::pair{wamit, "WAMIT .gdf"},
                                    {higher_order, "WAMIT .gdf"},
                                    {nemoh, "NEMOH .dat"},
                                    {hams, "HAMS .pnl"}})
    EXPECT_THAT(error_of(bytes),
                AllOf(HasSubstr(std::string("a.msh: found ") + name + ", panels of a hull"),
                      HasSubstr("plates without draft only")));
}

TEST(GmshErrors, NamesBigEndianBinary) {
  EXPECT_THAT(error_of(std::string("$MeshFormat\n4.1 1 8\n\0\0\0\1\n$EndMeshFormat\n", 41)),
              HasSubstr("found big-endian binary"));
  EXPECT_THAT(error_of(std::string("$MeshFormat\n2.2 1 8\n\7\0\0\0\n$EndMeshFormat\n", 41)),
              HasSubstr("mark of the byte order = 7"));
}

// All but the last line's end can be missed
TEST(GmshErrors, RefusesEveryTruncation) {
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
TEST(GmshErrors, SurvivesEverySpoiltByte) {
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

}  // namespace
}  // namespace floe::mesh
