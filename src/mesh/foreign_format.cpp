#include "mesh/foreign_format.hpp"

#include "mesh/hull_format.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace floe::mesh {
namespace {

struct Signature {
  std::string_view start;
  const char* name;
};

using namespace std::string_view_literals;

// First bytes of binary formats, first words (in lower case) of text formats
constexpr std::array kMagic = {
    Signature{"\x1f\x8b"sv, "gzip archive (unpack it first)"},
    Signature{"PK\x03\x04"sv, "zip archive (unpack it first)"},
    Signature{"BZh"sv, "bzip2 archive (unpack it first)"},
    Signature{"\xfd\x37zXZ"sv, "xz archive (unpack it first)"},
    Signature{"\x28\xb5\x2f\xfd"sv, "zstd archive (unpack it first)"},
    Signature{"\x89HDF"sv, "HDF5 file"},
    Signature{"CDF\x01"sv, "netCDF file"},
    Signature{"CDF\x02"sv, "netCDF file"},
    Signature{"\xff\xfe"sv, "text in UTF-16"},
    Signature{"\xfe\xff"sv, "text in UTF-16"},
};
constexpr std::array kFirstWords = {
    Signature{"$nod", "Gmsh MSH 1 mesh (save it as 2.2 or 4.1)"},
    Signature{"mesh", "GiD mesh"},
    Signature{"job", "AQWA input file"},
    Signature{"solid", "STL file"},
    Signature{"# vtk", "VTK legacy file (save it as VTU)"},
    Signature{"<?xml", "XML file"},
};

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

// The first lines, without blanks and without lines of comment (# of GiD, * of AQWA)
std::string first_statement(std::string_view bytes) {
  std::string_view rest = bytes.substr(0, 65536);
  while (true) {
    const std::size_t start = rest.find_first_not_of(" \t\r\n\v\f");
    if (start == std::string_view::npos) return "";
    rest.remove_prefix(start);
    const bool comment = (rest.front() == '#' && !rest.starts_with("# vtk")) || rest.front() == '*';
    if (!comment) return lower_case(rest.substr(0, 16));
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) return "";
    rest.remove_prefix(end);
  }
}

}  // namespace

std::string foreign_format(std::string_view bytes) {
  if (bytes.empty()) return "empty file";
  for (const Signature& magic : kMagic)
    if (bytes.starts_with(magic.start)) return magic.name;
  const std::string statement = first_statement(bytes);
  for (const Signature& word : kFirstWords) {
    const std::string_view rest =
        std::string_view(statement).substr(std::min(word.start.size(), statement.size()));
    const bool whole_word = rest.empty() || !std::isalnum(static_cast<unsigned char>(rest.front()));
    if (statement.starts_with(word.start) && whole_word) return word.name;
  }
  if (statement.starts_with("$")) return "";
  const std::string_view hull = hull_format(bytes);
  if (hull.empty()) return "file of unknown format";
  return std::string(hull) +
         ", panels of a hull (floe computes plates without draft only: mesh the outline at z = 0)";
}

}  // namespace floe::mesh
