#include "mesh/gmsh_element_types.hpp"

#include <algorithm>
#include <array>

namespace floe::mesh {
namespace {

// Numbers and node counts from the manual of Gmsh, "MSH file format"
constexpr std::array kTypes = {
    GmshElementType{1, 2, "lines"},
    GmshElementType{2, 3, "triangles"},
    GmshElementType{3, 4, "quadrilaterals"},
    GmshElementType{4, 4, "tetrahedra"},
    GmshElementType{5, 8, "hexahedra"},
    GmshElementType{6, 6, "prisms"},
    GmshElementType{7, 5, "pyramids"},
    GmshElementType{8, 3, "lines"},
    GmshElementType{9, 6, "triangles"},
    GmshElementType{10, 9, "quadrilaterals"},
    GmshElementType{11, 10, "tetrahedra"},
    GmshElementType{12, 27, "hexahedra"},
    GmshElementType{13, 18, "prisms"},
    GmshElementType{14, 14, "pyramids"},
    GmshElementType{15, 1, "points"},
    GmshElementType{16, 8, "quadrilaterals"},
    GmshElementType{17, 20, "hexahedra"},
    GmshElementType{18, 15, "prisms"},
    GmshElementType{19, 13, "pyramids"},
    GmshElementType{20, 9, "triangles"},
    GmshElementType{21, 10, "triangles"},
    GmshElementType{22, 12, "triangles"},
    GmshElementType{23, 15, "triangles"},
    GmshElementType{24, 15, "triangles"},
    GmshElementType{25, 21, "triangles"},
    GmshElementType{26, 4, "lines"},
    GmshElementType{27, 5, "lines"},
    GmshElementType{28, 6, "lines"},
    GmshElementType{29, 20, "tetrahedra"},
    GmshElementType{30, 35, "tetrahedra"},
    GmshElementType{31, 56, "tetrahedra"},
    GmshElementType{36, 16, "quadrilaterals"},
    GmshElementType{37, 25, "quadrilaterals"},
    GmshElementType{38, 36, "quadrilaterals"},
    GmshElementType{39, 12, "quadrilaterals"},
    GmshElementType{40, 16, "quadrilaterals"},
    GmshElementType{41, 20, "quadrilaterals"},
    GmshElementType{92, 64, "hexahedra"},
    GmshElementType{93, 125, "hexahedra"},
};

}  // namespace

const GmshElementType* gmsh_element_type(std::int64_t number) {
  const auto type = std::find_if(kTypes.begin(), kTypes.end(),
                                 [&](const GmshElementType& t) { return t.number == number; });
  return type == kTypes.end() ? nullptr : &*type;
}

bool is_gmsh_line(int number) {
  return number == 1 || number == 8 || (number >= 26 && number <= 28);
}

}  // namespace floe::mesh
