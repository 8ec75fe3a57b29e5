#include "mesh/file_bytes.hpp"

#include <floe/mesh/gmsh.hpp>

#include <charconv>

namespace floe::mesh {
namespace {

/// Collects text; numbers stand with the fewest digits that give the same number back.
class MshText {
 public:
  MshText& operator<<(std::string_view text) {
    text_ += text;
    return *this;
  }
  MshText& operator<<(double number) { return append(number); }
  MshText& operator<<(Index number) { return append(number); }

  const std::string& text() const { return text_; }

 private:
  template <typename Number>
  MshText& append(Number number) {
    char digits[32];
    text_.append(digits, std::to_chars(digits, digits + sizeof(digits), number).ptr);
    return *this;
  }

  std::string text_;
};

}  // namespace

void write_gmsh(const std::filesystem::path& path, const Q8Mesh& mesh) {
  // One surface entity that belongs to the physical surface "plate"
  MshText out;
  out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
      << "$PhysicalNames\n1\n2 1 \"plate\"\n$EndPhysicalNames\n"
      << "$Entities\n0 0 1 0\n1 " << mesh.lower().x() << " " << mesh.lower().y() << " 0 "
      << mesh.upper().x() << " " << mesh.upper().y() << " 0 1 1 0\n$EndEntities\n";

  // Nodes: all numbers, then all coordinates
  const Index nodes = mesh.node_count(), elements = mesh.element_count();
  out << "$Nodes\n1 " << nodes << " 1 " << nodes << "\n2 1 0 " << nodes << "\n";
  for (Index n = 0; n < nodes; ++n) out << n + 1 << "\n";
  for (Index n = 0; n < nodes; ++n)
    out << mesh.nodes()(0, n) << " " << mesh.nodes()(1, n) << " 0\n";

  // Elements of type 16, quadrilateral with 8 nodes
  out << "$EndNodes\n$Elements\n1 " << elements << " 1 " << elements << "\n2 1 16 " << elements
      << "\n";
  for (Index e = 0; e < elements; ++e) {
    out << e + 1;
    for (int a = 0; a < 8; ++a) out << " " << mesh.elements()(a, e) + 1;
    out << "\n";
  }
  out << "$EndElements\n";
  replace_file(path, out.text());
}

}  // namespace floe::mesh
