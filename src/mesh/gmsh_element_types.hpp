#pragma once

#include <cstdint>

namespace floe::mesh {

/// An element type of Gmsh.
struct GmshElementType {
  int number;
  int nodes;
  const char* name;  ///< plural
};

/// The type of that number; nullptr if Gmsh has none such (or none of fixed size).
const GmshElementType* gmsh_element_type(std::int64_t number);

inline constexpr int kGmshPoint = 15;
inline constexpr int kGmshQuad4 = 3, kGmshQuad8 = 16, kGmshQuad9 = 10;

/// Line elements of any order.
bool is_gmsh_line(int number);

}  // namespace floe::mesh
