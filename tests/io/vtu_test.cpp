#include "io/vtu.hpp"

#include "fabricated_results.hpp"
#include "test_case.hpp"

#include <floe/numeric/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>

namespace floe::io {
namespace {

using test::small_mesh;
using test::small_result;
using test::TestFolder;

std::string attribute(const std::string& element, const std::string& name) {
  const auto at = element.find(" " + name + "=\"");
  if (at == std::string::npos) return "";
  const auto from = at + name.size() + 3;
  return element.substr(from, element.find('"', from) - from);
}

// Elements of one name with their attributes, as text
std::vector<std::string> elements(const std::string& xml, const std::string& name) {
  std::vector<std::string> found;
  for (auto at = xml.find("<" + name + " "); at != std::string::npos;
       at = xml.find("<" + name + " ", at + 1))
    found.push_back(xml.substr(at, xml.find('>', at) - at + 1));
  return found;
}

std::uint64_t number_at(const std::string& bytes, std::size_t at) {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

// One appended array after the VTK rules: block count, block size, last block, compressed sizes
std::string inflate_array(const std::string& appended, std::size_t at) {
  const std::uint64_t blocks = number_at(appended, at), size = number_at(appended, at + 8),
                      partial = number_at(appended, at + 16);
  std::size_t from = at + 24 + 8 * blocks;
  std::string data;
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const std::uint64_t packed = number_at(appended, at + 24 + 8 * b);
    uLongf length = b + 1 == blocks && partial > 0 ? partial : size;
    std::string block(length, '\0');
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(block.data()), &length,
                         reinterpret_cast<const Bytef*>(appended.data() + from), packed),
              Z_OK);
    data += block.substr(0, length);
    from += packed;
  }
  return data;
}

template <typename Number>
std::vector<Number> as(const std::string& bytes) {
  std::vector<Number> values(bytes.size() / sizeof(Number));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

struct Vtu {
  std::string xml;
  std::map<std::string, std::string> array;  // decoded bytes by name
};

Vtu read_vtu(const std::string& file) {
  const auto start = file.find("<AppendedData encoding=\"raw\">");
  const auto appended = file.find('_', start) + 1;
  Vtu vtu{.xml = file.substr(0, start), .array = {}};
  for (const std::string& element : elements(vtu.xml, "DataArray"))
    if (attribute(element, "format") == "appended")
      vtu.array[attribute(element, "Name")] =
          inflate_array(file.substr(appended), std::stoul(attribute(element, "offset")));
  EXPECT_TRUE(file.ends_with("\n  </AppendedData>\n</VTKFile>\n"));
  return vtu;
}

TEST(Vtu, ReadsBackAsWritten) {
  const TestFolder folder;
  const mesh::Q8Mesh mesh = small_mesh();
  const NodeField field = small_result(0.4).fields[0];
  write_vtu(folder.path() / "field.vtu", mesh, field);
  const Vtu vtu = read_vtu(folder.read("field.vtu"));

  const std::string head = elements(vtu.xml, "VTKFile").at(0);
  EXPECT_EQ(attribute(head, "type"), "UnstructuredGrid");
  EXPECT_EQ(attribute(head, "compressor"), "vtkZLibDataCompressor");
  EXPECT_EQ(attribute(head, "header_type"), "UInt64");
  const std::string piece = elements(vtu.xml, "Piece").at(0);
  EXPECT_EQ(attribute(piece, "NumberOfPoints"), std::to_string(mesh.node_count()));
  EXPECT_EQ(attribute(piece, "NumberOfCells"), std::to_string(mesh.element_count()));

  const auto points = as<double>(vtu.array.at("Points"));
  const auto connectivity = as<std::int64_t>(vtu.array.at("connectivity"));
  const auto offsets = as<std::int64_t>(vtu.array.at("offsets"));
  const auto types = as<std::uint8_t>(vtu.array.at("types"));
  ASSERT_EQ(points.size(), 3u * static_cast<std::size_t>(mesh.node_count()));
  ASSERT_EQ(types.size(), static_cast<std::size_t>(mesh.element_count()));
  for (Index n = 0; n < mesh.node_count(); ++n)
    EXPECT_EQ(points[static_cast<std::size_t>(3 * n)], mesh.nodes()(0, n));
  for (Index e = 0; e < mesh.element_count(); ++e) {
    EXPECT_EQ(types[static_cast<std::size_t>(e)], 23);
    EXPECT_EQ(offsets[static_cast<std::size_t>(e)], 8 * (e + 1));
    for (int a = 0; a < 8; ++a)
      EXPECT_EQ(connectivity[static_cast<std::size_t>(8 * e + a)], mesh.elements()(a, e));
  }

  for (Index n = 0; n < mesh.node_count(); ++n) {
    const auto value = [&](const char* name) {
      return as<double>(vtu.array.at(name))[static_cast<std::size_t>(n)];
    };
    EXPECT_EQ(value("w_re"), field.deflection[n].real());
    EXPECT_EQ(value("w_im"), field.deflection[n].imag());
    EXPECT_EQ(value("w_abs"), std::abs(field.deflection[n]));
    EXPECT_EQ(value("w_phase"), std::arg(field.deflection[n]));
    EXPECT_EQ(value("rotation_x_re"), field.rotation_x[n].real());
    EXPECT_EQ(value("rotation_y_im"), field.rotation_y[n].imag());
    EXPECT_EQ(value("p_re"), field.pressure[n].real());
    EXPECT_EQ(value("p_im"), field.pressure[n].imag());
  }
}

TEST(Vtu, SplitsLargeArraysIntoBlocks) {
  const TestFolder folder;
  // 64 × 64 elements: 12 545 nodes, points of 301 080 bytes, more than one block of 262 144
  const mesh::Q8Mesh mesh =
      mesh::make_rectangle({.length = 64.0, .width = 64.0, .nx = 64, .ny = 64, .grading = 1.0});
  NodeField field;
  field.deflection = field.rotation_x = field.rotation_y = field.pressure =
      test::numbered(1.0, mesh.node_count(), 1);
  write_vtu(folder.path() / "field.vtu", mesh, field);
  const Vtu vtu = read_vtu(folder.read("field.vtu"));
  const auto points = as<double>(vtu.array.at("Points"));
  ASSERT_EQ(points.size(), 3u * static_cast<std::size_t>(mesh.node_count()));
  const Index last = mesh.node_count() - 1;
  EXPECT_EQ(points[static_cast<std::size_t>(3 * last + 1)], mesh.nodes()(1, last));
}

TEST(Vtu, RefusesFieldsThatAreNotFinite) {
  const TestFolder folder;
  NodeField field = small_result(0.4).fields[0];
  field.pressure[3] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(write_vtu(folder.path() / "field.vtu", small_mesh(), field), ConvergenceError);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "field.vtu"));
}

TEST(Pvd, ListsFilesOverFrequency) {
  const TestFolder folder;
  write_pvd(folder.path() / "fields.pvd", {{0.4, 0, "fields/a.vtu"}, {0.5, 1, "fields/b.vtu"}});
  const auto sets = elements(folder.read("fields.pvd"), "DataSet");
  ASSERT_EQ(sets.size(), 2u);
  EXPECT_EQ(attribute(sets[1], "timestep"), "0.5");
  EXPECT_EQ(attribute(sets[1], "part"), "1");
  EXPECT_EQ(attribute(sets[1], "file"), "fields/b.vtu");
}

}  // namespace
}  // namespace floe::io
