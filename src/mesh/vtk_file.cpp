#include "mesh/vtk_file.hpp"

#include "mesh/gmsh_scanner.hpp"

#include <floe/numeric/error.hpp>

#include <charconv>
#include <cmath>
#include <cstring>

namespace floe::mesh {
namespace {

// "Points", or "connectivity"
std::string name_of(const pugi::xml_node& array) {
  const std::string name = array.attribute("Name").value();
  return name.empty() ? array.parent().name() : name;
}

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

// Numbers in text; false if one is none
template <typename Number>
bool parse_text(std::string_view text, std::vector<Number>& values) {
  const char *at = text.data(), *const last = at + text.size();
  while (true) {
    while (at < last && is_blank(*at)) ++at;
    if (at == last) return true;
    Number value{};
    const auto [end, error] = std::from_chars(at + (*at == '+' ? 1 : 0), last, value);
    if (error != std::errc() || (end < last && !is_blank(*end))) return false;
    values.push_back(value);
    at = end;
  }
}

template <typename Stored, typename Number>
bool append(const std::string& bytes, std::vector<Number>& values) {
  if (bytes.size() % sizeof(Stored) != 0) return false;
  values.resize(bytes.size() / sizeof(Stored));
  for (std::size_t i = 0; i < values.size(); ++i) {
    Stored stored;
    std::memcpy(&stored, bytes.data() + i * sizeof(Stored), sizeof(Stored));
    if constexpr (std::is_integral_v<Number> && std::is_floating_point_v<Stored>) return false;
    values[i] = static_cast<Number>(stored);
  }
  return true;
}

// By VTK's name of the type
template <typename Number>
bool append_as(const std::string& type, const std::string& bytes, std::vector<Number>& values) {
  if (type == "Float64") return append<double>(bytes, values);
  if (type == "Float32") return append<float>(bytes, values);
  if (type == "Int64") return append<std::int64_t>(bytes, values);
  if (type == "UInt64") return append<std::uint64_t>(bytes, values);
  if (type == "Int32") return append<std::int32_t>(bytes, values);
  if (type == "UInt32") return append<std::uint32_t>(bytes, values);
  if (type == "Int16") return append<std::int16_t>(bytes, values);
  if (type == "UInt16") return append<std::uint16_t>(bytes, values);
  if (type == "Int8") return append<std::int8_t>(bytes, values);
  if (type == "UInt8") return append<std::uint8_t>(bytes, values);
  return false;
}

}  // namespace

VtkFile::VtkFile(std::string_view bytes, std::string file_name) : file_name_(std::move(file_name)) {
  // NOTE: raw appended data are no XML; the document ends where they begin
  std::string text(bytes);
  if (const std::size_t start = bytes.find("<AppendedData"); start != std::string_view::npos) {
    const std::size_t close = bytes.find('>', start), mark = bytes.find('_', close);
    if (close == std::string_view::npos || mark == std::string_view::npos)
      fail("AppendedData without the mark _ before the data");
    encoding_.appended = bytes.substr(mark + 1);
    text = std::string(bytes.substr(0, close)) + "></AppendedData></VTKFile>";
  }
  const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size());
  if (!result)
    fail("not valid XML at byte " + std::to_string(result.offset) + ": " + result.description());
  check_root(document_.child("VTKFile"));
}

void VtkFile::check_root(const pugi::xml_node& root) {
  const std::string type = root.attribute("type").value();
  if (type != "UnstructuredGrid")
    fail("found VTK " + printable(type) + " (must be UnstructuredGrid)");
  const std::string version = root.attribute("version").value();
  if (!version.empty() && !version.starts_with("0.") && !version.starts_with("1.") &&
      !version.starts_with("2."))
    fail("found VTU of version " + printable(version) + " (must be 0.1 to 2.x)");
  if (std::string_view(root.attribute("byte_order").value()) == "BigEndian")
    fail("found big-endian data (must be LittleEndian)");
  const std::string header = root.attribute("header_type").as_string("UInt32");
  if (header != "UInt32" && header != "UInt64")
    fail("found header_type " + printable(header) + " (must be UInt32 or UInt64)");
  encoding_.wide_header = header == "UInt64";
  const std::string compressor = root.attribute("compressor").value();
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    fail("found compressor " + printable(compressor) + " (must be vtkZLibDataCompressor or none)");
  encoding_.compressed = !compressor.empty();
  const std::string appended = root.child("AppendedData").attribute("encoding").as_string("raw");
  if (appended != "raw" && appended != "base64")
    fail("found AppendedData in " + printable(appended) + " (must be raw or base64)");
  encoding_.raw_appended = appended == "raw";

  const pugi::xml_node grid = root.child("UnstructuredGrid");
  piece_ = grid.child("Piece");
  if (!piece_) fail("no Piece in UnstructuredGrid");
  if (piece_.next_sibling("Piece")) fail("found several pieces (must be one: merge them)");
}

Index VtkFile::count(const char* attribute) const {
  const std::string_view text = piece_.attribute(attribute).value();
  Index value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0)
    fail(std::string("invalid ") + attribute + " = '" + printable(text) +
         "' (must be a whole number, 0 or more)");
  return value;
}

pugi::xml_node VtkFile::find(const char* child, const char* name) const {
  const pugi::xml_node parent = piece_.child(child);
  return *name ? parent.find_child_by_attribute("DataArray", "Name", name)
               : parent.child("DataArray");
}

pugi::xml_node VtkFile::require(const char* child, const char* name) const {
  const pugi::xml_node array = find(child, name);
  if (!array) fail(std::string("no array ") + name + " in " + child);
  return array;
}

std::string VtkFile::bytes_of(const pugi::xml_node& array) const {
  const bool inline_text = std::string_view(array.attribute("format").value()) == "binary";
  std::string_view text = array.child_value();
  if (!inline_text) {
    const std::string_view offset = array.attribute("offset").value();
    std::uint64_t at = 0;
    const auto [end, error] = std::from_chars(offset.data(), offset.data() + offset.size(), at);
    if (error != std::errc() || at > encoding_.appended.size())
      throw MeshError("invalid offset = '" + printable(offset) + "' (must be 0 to " +
                      std::to_string(encoding_.appended.size()) + ")");
    text = encoding_.appended.substr(at);
  }
  return decode_vtk_bytes(text, inline_text || !encoding_.raw_appended, encoding_);
}

template <typename Number>
std::vector<Number> VtkFile::numbers(const pugi::xml_node& array) const {
  const std::string type = array.attribute("type").value();
  const std::string format = array.attribute("format").as_string("ascii");
  std::vector<Number> values;
  try {
    if (format == "ascii") {
      if (!parse_text<Number>(array.child_value(), values))
        throw MeshError("found what is no number of its type");
    } else if (format == "binary" || format == "appended") {
      if (!append_as(type, bytes_of(array), values))
        throw MeshError("found type " + printable(type) + " (must be " +
                        (std::is_integral_v<Number> ? "integers" : "numbers") +
                        ", a whole number of them)");
    } else {
      throw MeshError("found format " + printable(format) + " (must be ascii, binary or appended)");
    }
  } catch (const MeshError& error) {
    fail("array " + printable(name_of(array)) + ": " + error.what());
  }
  return values;
}

std::vector<double> VtkFile::reals(const pugi::xml_node& array) const {
  return numbers<double>(array);
}

std::vector<std::int64_t> VtkFile::integers(const pugi::xml_node& array) const {
  return numbers<std::int64_t>(array);
}

void VtkFile::fail(const std::string& message) const {
  throw MeshError(file_name_ + ": " + message);
}

}  // namespace floe::mesh
