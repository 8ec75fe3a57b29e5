#include "mesh/file_bytes.hpp"

#include <floe/mesh/gmsh.hpp>

#include <algorithm>
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

// The groups, and what they leave over
std::vector<ElementGroup> all_groups(const Q8Mesh& mesh, const std::vector<ElementGroup>& groups) {
  std::vector<ElementGroup> all = groups;
  std::vector<bool> taken(static_cast<std::size_t>(mesh.element_count()), false);
  for (const ElementGroup& group : groups)
    for (const Index element : group.elements) taken[static_cast<std::size_t>(element)] = true;
  ElementGroup rest{"plate", {}};
  while (std::any_of(groups.begin(), groups.end(),
                     [&](const ElementGroup& group) { return group.name == rest.name; }))
    rest.name = "rest of " + rest.name;
  for (Index e = 0; e < mesh.element_count(); ++e)
    if (!taken[static_cast<std::size_t>(e)]) rest.elements.push_back(e);
  if (!rest.elements.empty()) all.push_back(std::move(rest));
  return all;
}

// A surface entity for each group, which belongs to the physical surface of that name
void write_surfaces(const Q8Mesh& mesh, const std::vector<ElementGroup>& groups, MshText& out) {
  const auto count = static_cast<Index>(groups.size());
  out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n" << count << "\n";
  for (Index g = 0; g < count; ++g)
    out << "2 " << g + 1 << " \"" << groups[static_cast<std::size_t>(g)].name << "\"\n";
  out << "$EndPhysicalNames\n$Entities\n0 0 " << count << " 0\n";
  for (Index g = 0; g < count; ++g)
    out << g + 1 << " " << mesh.lower().x() << " " << mesh.lower().y() << " 0 " << mesh.upper().x()
        << " " << mesh.upper().y() << " 0 1 " << g + 1 << " 0\n";
  out << "$EndEntities\n";
}

// All numbers, then all coordinates
void write_nodes(const Q8Mesh& mesh, MshText& out) {
  const Index nodes = mesh.node_count();
  out << "$Nodes\n1 " << nodes << " 1 " << nodes << "\n2 1 0 " << nodes << "\n";
  for (Index n = 0; n < nodes; ++n) out << n + 1 << "\n";
  for (Index n = 0; n < nodes; ++n)
    out << mesh.nodes()(0, n) << " " << mesh.nodes()(1, n) << " 0\n";
  out << "$EndNodes\n";
}

// Type 16, quadrilateral with 8 nodes
void write_elements(const Q8Mesh& mesh, const std::vector<ElementGroup>& groups, MshText& out) {
  const auto count = static_cast<Index>(groups.size());
  out << "$Elements\n"
      << count << " " << mesh.element_count() << " 1 " << mesh.element_count() << "\n";
  Index number = 0;
  for (Index g = 0; g < count; ++g) {
    const std::vector<Index>& elements = groups[static_cast<std::size_t>(g)].elements;
    out << "2 " << g + 1 << " 16 " << static_cast<Index>(elements.size()) << "\n";
    for (const Index e : elements) {
      out << ++number;
      for (int a = 0; a < 8; ++a) out << " " << mesh.elements()(a, e) + 1;
      out << "\n";
    }
  }
  out << "$EndElements\n";
}

}  // namespace

void write_gmsh(const std::filesystem::path& path, const Q8Mesh& mesh,
                const std::vector<ElementGroup>& groups) {
  const std::vector<ElementGroup> all = all_groups(mesh, groups);
  MshText out;
  write_surfaces(mesh, all, out);
  write_nodes(mesh, out);
  write_elements(mesh, all, out);
  replace_file(path, out.text());
}

}  // namespace floe::mesh
