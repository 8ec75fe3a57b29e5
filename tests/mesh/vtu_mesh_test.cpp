#include "gmsh_texts.hpp"

#include <floe/mesh/mesh_file.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace floe::mesh {
namespace {

using test::bytes_of;
using test::data_file;
using test::error_of;
using test::replaced;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

// A square of one element of a VTK type, without its arrays' encodings
std::string square(const std::string& type = "23", const std::string& nodes = "0 1 2 3 4 5 6 7",
                   const std::string& offset = "8", const std::string& cell_data = "") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n<UnstructuredGrid><Piece NumberOfPoints=\"9\" "
         "NumberOfCells=\"1\">\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
         "format=\"ascii\">0 0 0 2 0 0 2 2 0 0 2 0 1 0 0 2 1 0 1 2 0 0 1 0 1 1 0</DataArray>"
         "</Points>\n<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
         nodes + "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" +
         offset + "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">" +
         type + "</DataArray></Cells>" + cell_data + "</Piece></UnstructuredGrid></VTKFile>\n";
}

// meshio writes the coordinates that it read: the same to the last bit where binary, to 11 digits
// as text
TEST(Vtu, EveryEncodingOfMeshioGivesTheMeshOfTheGmshFile) {
  const std::pair<const char*, const char*> files[] = {
      {"sector_quad8_zlib.vtu", "sector_quad8_41.msh"},
      {"sector_quad8_base64.vtu", "sector_quad8_41.msh"},
      {"sector_quad8_ascii.vtu", "sector_quad8_41.msh"},
      {"sector_quad4_zlib.vtu", "sector_quad4_41.msh"},
      {"sector_quad9_zlib.vtu", "sector_quad9_41.msh"}};
  for (const auto& [vtu, msh] : files) {
    const MeshFile expected = read_mesh(data_file(msh)), found = read_mesh(data_file(vtu));
    ASSERT_EQ(found.mesh.node_count(), expected.mesh.node_count()) << vtu;
    EXPECT_EQ(found.mesh.elements(), expected.mesh.elements()) << vtu;
    const double tolerance = std::string(vtu).find("ascii") == std::string::npos ? 0.0 : 1e-10;
    EXPECT_LE((found.mesh.nodes() - expected.mesh.nodes()).cwiseAbs().maxCoeff(), tolerance) << vtu;
    EXPECT_EQ(found.notices, expected.notices) << vtu;
  }
}

TEST(Vtu, TakesPixelsAndLagrangeQuadrilateralsAndDropsLines) {
  EXPECT_EQ(error_of(square()), "");
  EXPECT_EQ(error_of(square("9", "0 1 2 3", "4")), "");
  EXPECT_EQ(error_of(square("8", "0 1 3 2", "4")), "");
  EXPECT_EQ(error_of(square("28", "0 1 2 3 4 5 6 7 8", "9")), "");
  EXPECT_EQ(error_of(square("70", "0 1 2 3 4 5 6 7 8", "9")), "");
  const std::string with_line = replaced(square("23 3", "0 1 2 3 4 5 6 7 0 1", "8 10"),
                                         "NumberOfCells=\"1\"", "NumberOfCells=\"2\"");
  EXPECT_THAT(read_mesh_bytes(with_line, "a.vtu").notices,
              ElementsAre("dropped 0 point elements, 1 line element and 1 node that no "
                          "quadrilateral uses"));
}

TEST(Vtu, MakesGroupsOfIntegerCellData) {
  for (const char* name : {"region", "gmsh:physical"}) {
    const MeshFile file =
        read_mesh_bytes(square("23", "0 1 2 3 4 5 6 7", "8",
                               std::string("<CellData><DataArray type=\"Int32\" Name=\"") + name +
                                   "\" format=\"ascii\">17</DataArray></CellData>"),
                        "a.vtu");
    ASSERT_EQ(file.groups.size(), 1u) << name;
    EXPECT_EQ(file.groups[0].name, "17");
    EXPECT_THAT(file.groups[0].elements, ElementsAre(0));
  }
}

TEST(Vtu, RefusesByNameWhatIsNotRead) {
  EXPECT_THAT(error_of(bytes_of(data_file("sector_quad8_lzma.vtu"))),
              HasSubstr("found compressor vtkLZMADataCompressor (must be vtkZLibDataCompressor"));
  EXPECT_THAT(error_of(replaced(square(), "LittleEndian", "BigEndian")),
              HasSubstr("found big-endian data"));
  EXPECT_THAT(error_of(replaced(square(), "UnstructuredGrid\"", "PolyData\"")),
              HasSubstr("found VTK PolyData (must be UnstructuredGrid)"));
  EXPECT_THAT(error_of(replaced(square(), "version=\"1.0\" byte", "version=\"3.0\" byte")),
              HasSubstr("found VTU of version 3.0"));
  EXPECT_THAT(error_of(replaced(square(), "</Piece>", "</Piece><Piece></Piece>")),
              HasSubstr("found several pieces"));
  EXPECT_THAT(error_of(square("22", "0 1 2 4 5 6", "6")),
              HasSubstr("invalid elements = 1 triangles with 6 nodes"));
  EXPECT_THAT(error_of(square("12", "0 1 2 3 4 5 6 7", "8")),
              HasSubstr("1 hexahedra with 8 nodes"));
  EXPECT_THAT(error_of(square("99", "0", "1")), HasSubstr("1 cells of VTK's type 99 with 1 nodes"));
  EXPECT_THAT(error_of(square("3", "0 1", "2")), HasSubstr("invalid quadrilaterals = 0"));
}

TEST(Vtu, RefusesDamagedFilesNamingTheArray) {
  EXPECT_THAT(error_of(square("23", "0 1 2 3 4 5 6 9", "8")),
              HasSubstr("a.msh: invalid node of cell 0 = 9 (must be 0 to 8)"));
  EXPECT_THAT(error_of(square("23", "0 1 2 3 4 5 6 -1", "8")), HasSubstr("cell 0 = -1"));
  EXPECT_THAT(error_of(square("23", "0 1 2 3 4 5 6 7", "9")),
              HasSubstr("invalid offset of cell 0"));
  EXPECT_THAT(error_of(square("23", "0 1 2 3 4 5 6", "7")),
              HasSubstr("invalid node count of cell 0 = 7 (must be 8 for VTK's type 23)"));
  EXPECT_THAT(error_of(square("23 9", "0 1 2 3 4 5 6 7", "8")),
              HasSubstr("invalid length of offsets and types = 1, 2 (must be 1)"));
  EXPECT_THAT(error_of(square("23", "0 1 2 three 4 5 6 7", "8")),
              HasSubstr("array connectivity: found what is no number"));
  EXPECT_THAT(error_of(replaced(square(), "0 0 0 2", "0 nan 0 2")),
              HasSubstr("invalid coordinate of point 0"));
  EXPECT_THAT(error_of(replaced(square(), "NumberOfPoints=\"9\"", "NumberOfPoints=\"8\"")),
              HasSubstr("invalid length of Points = 27"));
  EXPECT_THAT(error_of(replaced(square(), "NumberOfCells=\"1\"", "NumberOfCells=\"x\"")),
              HasSubstr("invalid NumberOfCells = 'x'"));
  EXPECT_THAT(error_of(replaced(square(), "offsets", "offset")), HasSubstr("no array offsets"));
  EXPECT_THAT(error_of(replaced(square(), "</Cells>", "")), HasSubstr("not valid XML at byte"));
}

// Neither a crash nor a mesh: the last bytes hold the end of the document
TEST(Vtu, RefusesEveryTruncationAndEveryFlippedByteOfItsData) {
  for (const char* name : {"sector_quad8_zlib.vtu", "sector_quad8_base64.vtu"}) {
    const std::string bytes = bytes_of(data_file(name));
    for (std::size_t end = 0; end + 12 < bytes.size(); end += 7)
      EXPECT_NE(error_of(bytes.substr(0, end)), "") << name << " " << end;
  }
  // Whatever stands there, the reader answers with a mesh or a MeshError
  const std::string bytes = bytes_of(data_file("sector_quad8_zlib.vtu"));
  for (std::size_t at = 0; at < bytes.size(); at += 3)
    for (const char c : {'\0', '9', 'A', '<'}) {
      std::string spoilt = bytes;
      spoilt[at] = c;
      static_cast<void>(error_of(spoilt));
    }
}

}  // namespace
}  // namespace floe::mesh
