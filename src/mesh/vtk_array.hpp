#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace floe::mesh {

/// How the arrays of a VTK XML file lie in it.
struct VtkEncoding {
  bool wide_header = false;        ///< counts of bytes have 8 bytes instead of 4
  bool compressed = false;         ///< by zlib, in blocks
  bool raw_appended = true;        ///< appended data as they are, else in base64
  std::string_view appended = {};  ///< what follows the mark _
};

/// Bytes of an array whose header begins with `text`: in base64, or raw as they lie. Throws
/// MeshError without a place: what is wrong, and what is required.
std::string decode_vtk_bytes(std::string_view text, bool base64, const VtkEncoding& encoding);

}  // namespace floe::mesh
