#include "mesh/vtu_content.hpp"

#include "mesh/vtk_file.hpp"

#include <algorithm>
#include <cmath>

namespace floe::mesh {
namespace {

enum class CellKind { kPoint, kLine, kQuad, kOther };

struct CellType {
  std::int64_t number;
  CellKind kind;
  int nodes;         // 0: any number
  const char* name;  // plural
};

// Numbers from VTK's vtkCellType.h
constexpr CellType kCellTypes[] = {
    {1, CellKind::kPoint, 1, "points"},
    {2, CellKind::kPoint, 0, "points"},
    {3, CellKind::kLine, 2, "lines"},
    {4, CellKind::kLine, 0, "lines"},
    {5, CellKind::kOther, 3, "triangles"},
    {6, CellKind::kOther, 0, "triangle strips"},
    {7, CellKind::kOther, 0, "polygons"},
    {8, CellKind::kQuad, 4, "pixels"},
    {9, CellKind::kQuad, 4, "quadrilaterals"},
    {10, CellKind::kOther, 4, "tetrahedra"},
    {11, CellKind::kOther, 8, "voxels"},
    {12, CellKind::kOther, 8, "hexahedra"},
    {13, CellKind::kOther, 6, "wedges"},
    {14, CellKind::kOther, 5, "pyramids"},
    {21, CellKind::kLine, 3, "lines"},
    {22, CellKind::kOther, 6, "triangles"},
    {23, CellKind::kQuad, 8, "quadrilaterals"},
    {24, CellKind::kOther, 10, "tetrahedra"},
    {25, CellKind::kOther, 20, "hexahedra"},
    {26, CellKind::kOther, 15, "wedges"},
    {27, CellKind::kOther, 13, "pyramids"},
    {28, CellKind::kQuad, 9, "quadrilaterals"},
    {29, CellKind::kOther, 27, "hexahedra"},
    {30, CellKind::kOther, 6, "quadrilaterals, quadratic one way and linear the other,"},
    {34, CellKind::kOther, 7, "triangles"},
    {35, CellKind::kLine, 4, "lines"},
    {42, CellKind::kOther, 0, "polyhedra"},
    {68, CellKind::kLine, 0, "lines"},
    {69, CellKind::kOther, 0, "triangles"},
    {70, CellKind::kQuad, 0, "quadrilaterals"},
    {71, CellKind::kOther, 0, "tetrahedra"},
    {72, CellKind::kOther, 0, "hexahedra"},
};
constexpr std::int64_t kPixel = 8;
constexpr std::int64_t kManyNodes = 1'000'000;  // more than any cell that is read has

/// Goes through the cells of a file.
class CellReader {
 public:
  CellReader(const VtkFile& file, Index point_count)
      : file_(file),
        points_(point_count),
        connectivity_(file.integers(file.require("Cells", "connectivity"))),
        offsets_(file.integers(file.require("Cells", "offsets"))),
        types_(file.integers(file.require("Cells", "types"))) {
    const auto cells = static_cast<std::size_t>(file.count("NumberOfCells"));
    if (offsets_.size() != cells || types_.size() != cells)
      file.fail("invalid length of offsets and types = " + std::to_string(offsets_.size()) + ", " +
                std::to_string(types_.size()) + " (must be " + std::to_string(cells) + ")");
  }

  /// Puts them into `content`; which quad each cell is, or -1.
  std::vector<Index> read(FileContent& content) const {
    std::vector<Index> quad_of_cell;
    std::int64_t first = 0;
    for (std::size_t cell = 0; cell < types_.size(); ++cell) {
      const std::int64_t end = offsets_[cell];
      if (end < first || end > static_cast<std::int64_t>(connectivity_.size()))
        file_.fail("invalid offset of cell " + std::to_string(cell) + " = " + std::to_string(end) +
                   " (must be " + std::to_string(first) + " to " +
                   std::to_string(connectivity_.size()) + ")");
      const std::size_t quads = content.quads.size();
      read_cell(cell, first, static_cast<int>(std::min<std::int64_t>(end - first, kManyNodes)),
                content);
      quad_of_cell.push_back(content.quads.size() > quads ? static_cast<Index>(quads) : -1);
      first = end;
    }
    return quad_of_cell;
  }

 private:
  void read_cell(std::size_t cell, std::int64_t first, int nodes, FileContent& content) const {
    const auto* const type =
        std::find_if(std::begin(kCellTypes), std::end(kCellTypes),
                     [&](const CellType& t) { return t.number == types_[cell]; });
    const bool known = type != std::end(kCellTypes);
    if (known && type->nodes > 0 && type->nodes != nodes)
      file_.fail("invalid node count of cell " + std::to_string(cell) + " = " +
                 std::to_string(nodes) + " (must be " + std::to_string(type->nodes) +
                 " for VTK's type " + std::to_string(types_[cell]) + ")");
    if (known && type->kind == CellKind::kPoint) {
      ++content.point_elements;
    } else if (known && type->kind == CellKind::kLine) {
      ++content.line_elements;
    } else if (known && type->kind == CellKind::kQuad && (nodes == 4 || nodes == 8 || nodes == 9)) {
      content.quads.push_back(quad(cell, first, nodes));
    } else {
      const std::string name =
          known ? type->name : "cells of VTK's type " + std::to_string(types_[cell]);
      ++content.refused[name + " with " + std::to_string(nodes) + " nodes"];
    }
  }

  FileQuad quad(std::size_t cell, std::int64_t first, int nodes) const {
    FileQuad quad{nodes, {}, 0};
    for (int a = 0; a < nodes; ++a) {
      const std::int64_t node = connectivity_[first + a];
      if (node < 0 || node >= points_)
        file_.fail("invalid node of cell " + std::to_string(cell) + " = " + std::to_string(node) +
                   " (must be 0 to " + std::to_string(points_ - 1) + ")");
      quad.nodes[a] = node;
    }
    if (types_[cell] == kPixel) std::swap(quad.nodes[2], quad.nodes[3]);
    return quad;
  }

  const VtkFile& file_;
  Index points_;
  std::vector<std::int64_t> connectivity_, offsets_, types_;
};

void read_points(const VtkFile& file, FileContent& content) {
  const Index count = file.count("NumberOfPoints");
  const std::vector<double> values = file.reals(file.require("Points", ""));
  if (values.size() % 3 != 0 || static_cast<Index>(values.size() / 3) != count)
    file.fail("invalid length of Points = " + std::to_string(values.size()) +
              " numbers (must be 3 for each of " + std::to_string(count) + " points)");
  for (std::size_t i = 0; i < values.size(); i += 3) {
    if (!std::isfinite(values[i]) || !std::isfinite(values[i + 1]) || !std::isfinite(values[i + 2]))
      file.fail("invalid coordinate of point " + std::to_string(i / 3) + " (must be finite)");
    content.coordinates.emplace_back(values[i], values[i + 1], values[i + 2]);
  }
}

void read_groups(const VtkFile& file, const std::vector<Index>& quad_of_cell,
                 FileContent& content) {
  for (const char* const name : {"region", "gmsh:physical"}) {
    const pugi::xml_node array = file.find("CellData", name);
    if (!array) continue;
    const std::vector<std::int64_t> region = file.integers(array);
    if (region.size() != quad_of_cell.size())
      file.fail(std::string("invalid length of ") + name + " = " + std::to_string(region.size()) +
                " (must be " + std::to_string(quad_of_cell.size()) + ", one a cell)");
    std::map<std::int64_t, std::vector<Index>> elements;
    for (std::size_t cell = 0; cell < region.size(); ++cell)
      if (quad_of_cell[cell] >= 0) elements[region[cell]].push_back(quad_of_cell[cell]);
    for (auto& [number, quads] : elements)
      content.groups.push_back({std::to_string(number), std::move(quads)});
    return;
  }
}

}  // namespace

bool is_vtk_xml(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, 4096);
  const std::size_t first = start.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || start[first] != '<') return false;
  return start.find("<VTKFile") != std::string_view::npos;
}

FileContent parse_vtu(std::string_view bytes, const std::string& file_name) {
  const VtkFile file(bytes, file_name);
  FileContent content;
  read_points(file, content);
  const CellReader cells(file, static_cast<Index>(content.coordinates.size()));
  read_groups(file, cells.read(content), content);
  return content;
}

}  // namespace floe::mesh
