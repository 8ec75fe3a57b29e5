#include "fault.hpp"
#include "gmsh_texts.hpp"

#include <fmt/format.h>

// Meshes: rows 19 … 35, Gmsh files and the generator
namespace floe::test {
namespace {

// The case on a mesh whose waves are 100 m and more; the square of gmsh_texts.hpp is 2 m wide
std::string case_on(const std::string& name) {
  return with_mesh_file(name) + "[modes]\ncount = 6\n";
}

Fault mesh_fault(int row, const std::string& name, int code, const std::string& says,
                 const std::string& bytes, const std::string& arguments = "check case.toml") {
  return {
      row, name, code, says, case_on("plate.msh"), arguments, [bytes](const TestFolder& folder) {
        folder.write("plate.msh", bytes);
      }};
}

std::string scaled_22(double factor) {
  const double a = 2.0 * factor, b = factor;
  return fmt::format(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 0 0 0\n2 {0} 0 0\n3 {0} {0} 0\n4 0 {0} "
      "0\n5 {1} 0 0\n6 {0} {1} 0\n7 {1} {0} 0\n8 0 {1} 0\n$EndNodes\n$Elements\n1\n"
      "1 16 2 0 1 1 2 3 4 5 6 7 8\n$EndElements\n",
      a, b);
}

// Two squares side by side, each with nodes of its own
std::string two_squares(double gap) {
  return square_22(fmt::format("9 {0} 0 0\n10 {1} 0 0\n11 {1} 2 0\n12 {0} 2 0\n13 {2} 0 0\n14 {1} "
                               "1 0\n15 {2} 2 0\n16 {0} 1 0\n",
                               2.0 + gap, 4.0 + gap, 3.0 + gap),
                   8, "2 16 2 0 1 9 10 11 12 13 14 15 16\n", 1);
}

// Rows 19 and 20: counts and tags
std::vector<Fault> wrong_counts() {
  const std::string square = square_22();
  return {
      mesh_fault(19, "Truncated", 4, "plate.msh:", square.substr(0, square.size() / 2)),
      mesh_fault(19, "TruncatedBinary", 4, "plate.msh",
                 bytes_of(data_file("sector_quad8_41_bin.msh")).substr(0, 900)),
      mesh_fault(19, "CountBeyondTheFile", 4, "plate.msh:5: invalid node count = 4000000000",
                 replaced(square, "\n8\n1 0", "\n4000000000\n1 0")),
      mesh_fault(19, "CountBeyond63Bits", 4, "plate.msh:5: invalid node count",
                 replaced(square, "\n8\n1 0", "\n9223372036854775808\n1 0")),
      mesh_fault(19, "NegativeCount", 4, "plate.msh:5: invalid node count = -1",
                 replaced(square, "\n8\n1 0", "\n-1\n1 0")),
      mesh_fault(19, "TrailingJunk", 4, "plate.msh:19: found 'junk'", square + "junk"),
      mesh_fault(20, "NodeZero", 4, "plate.msh:11: invalid node tag = 0",
                 replaced(square, "6 2 1 0", "0 2 1 0")),
      mesh_fault(20, "NegativeNode", 4, "invalid node tag = -6",
                 replaced(square, "6 2 1 0", "-6 2 1 0")),
      mesh_fault(20, "UnknownNode", 4, "plate.msh:17: invalid node tag = 9",
                 replaced(square, "5 6 7 8\n$", "5 6 7 9\n$")),
      mesh_fault(20, "HugeTagsWithGaps", 0, "8 nodes, 1 element",
                 replaced(replaced(replaced(square_41(), "2 8 1 8", "2 8 1 4611686018427387904"),
                                   "6\n7\n8\n", "6\n7\n4611686018427387904\n"),
                          "6 7 8\n$", "6 7 4611686018427387904\n$")),
  };
}

// Rows 21 to 27: coordinates and elements
std::vector<Fault> wrong_shapes() {
  const std::string square = square_22();
  return {
      mesh_fault(21, "NanCoordinate", 4,
                 "plate.msh:11: invalid coordinate y (must be a finite number)",
                 replaced(square, "6 2 1 0", "6 2 nan 0")),
      mesh_fault(21, "InfCoordinate", 4,
                 "plate.msh:11: invalid coordinate y (must be a finite number)",
                 replaced(square, "6 2 1 0", "6 2 inf 0")),
      mesh_fault(21, "Millimetres", 3, "invalid mesh resolution", scaled_22(3e5)),
      mesh_fault(21, "MillimetresAllowed", 3,
                 "even with --allow-coarse; are mesh and depth in metres?", scaled_22(3e6),
                 "check case.toml --allow-coarse"),
      mesh_fault(22, "ZeroArea", 4, "degenerate or folded elements",
                 replaced(replaced(square, "3 2 2 0", "3 2 0 0"), "4 0 2 0", "4 0 0 0")),
      mesh_fault(22, "RepeatedNode", 4, "element 1 has node 2 twice",
                 replaced(square, "1 2 3 4 5", "1 2 2 4 5")),
      mesh_fault(23, "FoldedByAMidNode", 4, "det J", replaced(square, "5 1 0 0", "5 1.99 1.5 0")),
      mesh_fault(23, "NodesInWrongOrder", 4, "element 1",
                 replaced(square, "1 2 3 4 5 6 7 8\n$", "1 3 2 4 5 6 7 8\n$")),
      mesh_fault(24, "Triangles", 4, "1 triangles with 3 nodes",
                 square_22("", 0, "2 2 2 0 1 1 2 3\n", 1)),
      mesh_fault(24, "LinesAndPointsDropped", 0, "dropped 1 point element, 1 line element",
                 square_22("9 5 5 0\n", 1, "2 15 2 0 1 9\n3 1 2 0 1 1 2\n", 2)),
      mesh_fault(25, "Clockwise", 0, "1 clockwise element was turned",
                 replaced(square, "1 2 3 4 5 6 7 8\n$", "1 4 3 2 8 7 6 5\n$")),
      mesh_fault(26, "SameElementTwice", 4, "element",
                 square_22("", 0, "2 16 2 0 1 1 2 3 4 5 6 7 8\n", 1)),
      mesh_fault(26, "OverlappingPlates", 4, "hanging nodes = 4 (elements must meet",
                 two_squares(-0.5)),
      mesh_fault(27, "AboveTheWater", 4, "invalid z = 0 to 0.1 m",
                 replaced(square, "7 1 2 0", "7 1 2 0.1")),
  };
}

// Rows 29 to 35: the whole mesh
std::vector<Fault> wrong_meshes() {
  std::vector<Fault> faults = {
      mesh_fault(29, "SeparateParts", 0, "2 pieces", two_squares(1.0)),
      mesh_fault(29, "UnmergedNodes", 4, "coincident nodes", two_squares(0.0)),
      {30, "TooCoarse", 3, "invalid mesh resolution = 0.73 nodes per wavelength at omega = 1.5",
       with("[0.4, 0.5]", "[0.4, 1.5]")},
      {30, "TooCoarseAllowed", 0, "coarse mesh: 0.73 nodes per wavelength",
       with("[0.4, 0.5]", "[0.4, 1.5]"), "run case.toml --allow-coarse"},
      {46, "TooCoarseToIterate", 0,
       "iterations (must be at most 1e-06); tried once more by a dense",
       replaced(with("length = 300.0, width = 60.0, nx = 4, ny = 2",
                     "length = 60.0, width = 12.0, nx = 20, ny = 4"),
                "[0.4, 0.5]", "[4.0]") +
           "[solver]\nmethod = \"lattice\"\n[modes]\ncount = 4\n",
       "run case.toml --allow-coarse"},
      {31, "SlenderElements", 0, "slender elements: aspect ratio",
       with("width = 60.0", "width = 1.0")},
      {32, "OneElement", 0, "results",
       with("nx = 4, ny = 2", "nx = 1, ny = 1") + "[modes]\ncount = 6\n",
       "run case.toml --allow-coarse"},
      mesh_fault(32, "NoElements", 4, "quadrilaterals = 0",
                 replaced(square_22(), "1 16 2 0 1 1 2 3 4 5 6 7 8", "1 1 2 0 1 1 2")),
      {32, "ThreeMillionElements", 6, "(must be at most 1.07 GB",
       with("nx = 4, ny = 2", "nx = 3000, ny = 1000"), "check case.toml --memory 1G"},
      {32, "TooManyElementsToCount", 6, "elements (must be at most 100000000)",
       with("nx = 4, ny = 2", "nx = 100000, ny = 100000")},
      mesh_fault(33, "AnEmptyFile", 4, "plate.msh: found empty file", ""),
      mesh_fault(33, "Gzip", 4, "gzip", "\x1f\x8b\x08 rest"),
      mesh_fault(33, "TextOfAnotherKind", 4, "plate.msh", "COOR 11 1.0 2.0 3.0\n"),
      {33, "DirectoryAsMesh", 4, "(must be a regular file)", case_on("folder"), "check case.toml",
       [](const TestFolder& folder) {
         std::filesystem::create_directory(folder.path() / "folder");
       }},
      {33, "MissingMesh", 4, "case.toml:9:8: invalid mesh.file = \"none.msh\" (cannot read",
       case_on("none.msh")},
  };
  return faults;
}

}  // namespace

std::vector<Fault> mesh_faults() {
  std::vector<Fault> all = wrong_counts();
  for (const auto& part : {wrong_shapes(), wrong_meshes()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace floe::test
