#include "mesh/gmsh_content.hpp"
#include "mesh/gmsh_element_types.hpp"
#include "mesh/gmsh_groups.hpp"
#include "mesh/gmsh_scanner.hpp"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>

namespace floe::mesh {
namespace {

/// Goes through the sections of a .msh file.
class GmshParser {
 public:
  GmshParser(std::string_view bytes, const std::string& file_name) : scan_(bytes, file_name) {}

  FileContent parse() {
    while (!scan_.at_end()) read_section();
    if (!has_nodes_) scan_.fail("no section $Nodes");
    if (!has_elements_) scan_.fail("no section $Elements");
    content_.groups = groups_.named();
    return std::move(content_);
  }

 private:
  enum class Version { kUnknown, k22, k41 };

  void read_section() {
    const std::string name(scan_.word("a section"));
    if (name.front() != '$' || name.size() < 2 || name.starts_with("$End"))
      scan_.fail("found '" + printable(name) + "' (must be the start of a section)");
    if (name == "$MeshFormat") {
      read_format();
    } else if (name == "$Nodes" || name == "$Elements") {
      if (version_ == Version::kUnknown) scan_.fail(name + " without $MeshFormat before it");
      name == "$Nodes" ? read_nodes() : read_elements();
    } else if (name == "$PhysicalNames") {
      read_physical_names();
    } else if (name == "$Entities" && version_ == Version::k41) {
      read_entities();
    } else if (name == "$ParametricNodes") {
      scan_.fail("found $ParametricNodes (must be saved without parametric coordinates)");
    } else {
      scan_.skip_behind("$End" + name.substr(1));
      return;
    }
    scan_.expect("$End" + name.substr(1));
  }

  void read_format() {
    if (version_ != Version::kUnknown) scan_.fail("a second $MeshFormat");
    const std::string version(scan_.word("the version"));
    if (version != "2.2" && version != "4.1")
      scan_.fail("found Gmsh MSH " + printable(version) + " (must be saved as 2.2 or 4.1)");
    const std::int64_t type = scan_.text_integer("file type");
    if (type != 0 && type != 1) scan_.fail("file type", type, "must be 0, ASCII, or 1, binary");
    const std::int64_t data_size = scan_.text_integer("data size");
    if (data_size != 8) scan_.fail("data size", data_size, "must be 8 bytes");
    version_ = version == "2.2" ? Version::k22 : Version::k41;
    if (type == 0) return;

    // Binary files hold the number 1, which tells the order of bytes
    scan_.end_line();
    scan_.set_binary();
    const std::int64_t one = scan_.integer("the mark of the byte order");
    if (one == 0x01000000) scan_.fail("found big-endian binary (must be little-endian, or ASCII)");
    if (one != 1) scan_.fail("mark of the byte order", one, "must be 1");
  }

  // In text, in binary files too: dimension, number, "name"
  void read_physical_names() {
    const std::int64_t count = scan_.text_integer("count of physical names");
    scan_.demand_room(count, 7, "count of physical names");
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t dimension = scan_.text_integer("dimension of a physical group");
      const std::int64_t tag = scan_.text_integer("number of a physical group");
      const std::string name = scan_.quoted("name of a physical group");
      if (dimension == 2) groups_.name(tag, name);
    }
  }

  // Points, curves, surfaces, volumes: what they are made of, and their physical groups
  void read_entities() {
    if (scan_.binary()) scan_.end_line();
    std::array<std::int64_t, 4> count{};
    for (std::int64_t& n : count) {
      n = scan_.size("entity count");
      scan_.demand_room(n, scan_.binary() ? 32 : 8, "entity count");
    }
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::int64_t i = 0; i < count[dimension]; ++i) read_entity(dimension);
  }

  void read_entity(int dimension) {
    const std::int64_t entity = scan_.integer("entity tag");
    for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) scan_.real("extent of an entity");
    const auto read_tags = [&](const char* what, const auto& take) {
      const std::int64_t count = scan_.size(what);
      scan_.demand_room(count, scan_.binary() ? 4 : 2, what);
      for (std::int64_t i = 0; i < count; ++i) take(scan_.integer(what));
    };
    read_tags("physical groups of an entity", [&](std::int64_t tag) {
      // NOTE: a negative number means the surface turned over, as part of the same group
      if (tag == std::numeric_limits<std::int64_t>::min())
        scan_.fail("physical group", tag, "must be one of Gmsh's");
      if (dimension == 2) groups_.put_surface(entity, std::abs(tag));
    });
    if (dimension > 0) read_tags("boundary of an entity", [](std::int64_t) {});
  }

  void read_nodes() {
    if (std::exchange(has_nodes_, true)) scan_.fail("a second $Nodes");
    version_ == Version::k22 ? read_nodes_22() : read_nodes_41();
  }

  void read_nodes_22() {
    const std::int64_t count = scan_.text_integer("node count");
    if (scan_.binary()) scan_.end_line();
    scan_.demand_room(count, scan_.binary() ? 28 : 8, "node count");
    reserve_nodes(count);
    for (std::int64_t n = 0; n < count; ++n) {
      add_tag(scan_.integer("node tag"), content_.coordinates.size());
      content_.coordinates.push_back(read_position());
    }
  }

  void read_nodes_41() {
    if (scan_.binary()) scan_.end_line();
    const std::int64_t blocks = scan_.size("node block count");
    const std::int64_t count = scan_.size("node count");
    scan_.size("smallest node tag");
    scan_.size("largest node tag");
    scan_.demand_room(count, scan_.binary() ? 32 : 8, "node count");
    reserve_nodes(count);
    for (std::int64_t block = 0; block < blocks; ++block) read_node_block_41(count);
    const auto found = static_cast<std::int64_t>(content_.coordinates.size());
    if (found != count) scan_.fail("nodes in blocks", found, "must be " + std::to_string(count));
  }

  void read_node_block_41(std::int64_t count_of_all) {
    const std::int64_t dimension = scan_.integer("entity dimension");
    if (dimension < 0 || dimension > 3) scan_.fail("entity dimension", dimension, "must be 0 to 3");
    scan_.integer("entity tag");
    const std::int64_t parametric = scan_.integer("parametric flag");
    if (parametric != 0 && parametric != 1)
      scan_.fail("parametric flag", parametric, "must be 0 or 1");
    const std::int64_t count = scan_.size("nodes in block");
    const std::size_t before = content_.coordinates.size();
    const std::int64_t left = count_of_all - static_cast<std::int64_t>(before);
    if (count > left)
      scan_.fail("nodes in block", count, "must be at most " + std::to_string(left));

    // All tags of the block stand before its coordinates
    for (std::int64_t n = 0; n < count; ++n)
      add_tag(scan_.size("node tag"), before + static_cast<std::size_t>(n));
    for (std::int64_t n = 0; n < count; ++n) {
      content_.coordinates.push_back(read_position());
      for (int i = 0; i < parametric * dimension; ++i) scan_.real("parametric coordinate");
    }
  }

  void reserve_nodes(std::int64_t count) {
    content_.coordinates.reserve(static_cast<std::size_t>(count));
    content_.tags.reserve(static_cast<std::size_t>(count));
    node_of_tag_.reserve(static_cast<std::size_t>(count));
  }

  void add_tag(std::int64_t tag, std::size_t node) {
    if (tag < 1) scan_.fail("node tag", tag, "must be positive");
    if (!node_of_tag_.emplace(tag, static_cast<Index>(node)).second)
      scan_.fail("node tag", tag, "must stand once");
    content_.tags.push_back(tag);
  }

  Eigen::Vector3d read_position() {
    const double x = scan_.real("coordinate x");
    const double y = scan_.real("coordinate y");
    return {x, y, scan_.real("coordinate z")};
  }

  void read_elements() {
    if (!has_nodes_) scan_.fail("$Elements before $Nodes");
    if (std::exchange(has_elements_, true)) scan_.fail("a second $Elements");
    if (version_ == Version::k41)
      read_elements_41();
    else
      read_elements_22();
  }

  void read_elements_22() {
    const std::int64_t count = scan_.text_integer("element count");
    if (scan_.binary()) scan_.end_line();
    scan_.demand_room(count, 8, "element count");
    for (std::int64_t done = 0; done < count;) {
      // ASCII: number, type, tags; binary: type, elements of that type, tags, then each number
      std::int64_t number = scan_.binary() ? 0 : scan_.integer("element number");
      const GmshElementType& type = read_type();
      const std::int64_t block = scan_.binary() ? scan_.integer("elements in block") : 1;
      if (block < 1 || block > count - done)
        scan_.fail("elements in block", block, "must be 1 to " + std::to_string(count - done));
      const std::int64_t tags = scan_.integer("tag count");
      scan_.demand_room(tags, scan_.binary() ? 4 : 2, "tag count");
      for (std::int64_t i = 0; i < block; ++i) {
        if (scan_.binary()) number = scan_.integer("element number");
        std::int64_t physical = 0;  // the first tag; 0 means none
        for (std::int64_t t = 0; t < tags; ++t) {
          const std::int64_t tag = scan_.integer("element tag");
          if (t == 0) physical = tag;
        }
        read_element(type, number);
        if (is_quad(type) && physical != 0) groups_.put_element(physical, last_quad());
      }
      done += block;
    }
  }

  void read_elements_41() {
    if (scan_.binary()) scan_.end_line();
    const std::int64_t blocks = scan_.size("element block count");
    const std::int64_t count = scan_.size("element count");
    scan_.size("smallest element tag");
    scan_.size("largest element tag");
    scan_.demand_room(count, scan_.binary() ? 16 : 4, "element count");
    std::int64_t left = count;
    for (std::int64_t block = 0; block < blocks; ++block) {
      scan_.integer("entity dimension");
      const std::int64_t entity = scan_.integer("entity tag");
      const GmshElementType& type = read_type();
      const std::int64_t in_block = scan_.size("elements in block");
      if (in_block > left)
        scan_.fail("elements in block", in_block, "must be at most " + std::to_string(left));
      for (std::int64_t i = 0; i < in_block; ++i) {
        read_element(type, scan_.size("element tag"));
        if (is_quad(type)) groups_.put_element_of(entity, last_quad());
      }
      left -= in_block;
    }
    if (left != 0)
      scan_.fail("elements in blocks", count - left, "must be " + std::to_string(count));
  }

  const GmshElementType& read_type() {
    const std::int64_t number = scan_.integer("element type");
    const GmshElementType* type = gmsh_element_type(number);
    if (type == nullptr) scan_.fail("element type", number, "must be one of Gmsh's element types");
    return *type;
  }

  static bool is_quad(const GmshElementType& type) {
    return type.number == kGmshQuad4 || type.number == kGmshQuad8 || type.number == kGmshQuad9;
  }
  Index last_quad() const { return static_cast<Index>(content_.quads.size()) - 1; }

  void read_element(const GmshElementType& type, std::int64_t number) {
    FileQuad quad{type.nodes, {}, number};
    const bool quadrilateral = is_quad(type);
    for (int a = 0; a < type.nodes; ++a) {
      const std::int64_t tag =
          version_ == Version::k22 ? scan_.integer("node tag") : scan_.size("node tag");
      const auto node = node_of_tag_.find(tag);
      if (node == node_of_tag_.end()) scan_.fail("node tag", tag, "must be one of $Nodes");
      if (quadrilateral) quad.nodes[a] = node->second;
    }
    if (quadrilateral)
      content_.quads.push_back(quad);
    else if (type.number == kGmshPoint)
      ++content_.point_elements;
    else if (is_gmsh_line(type.number))
      ++content_.line_elements;
    else
      ++content_.refused[std::string(type.name) + " with " + std::to_string(type.nodes) + " nodes"];
  }

  GmshScanner scan_;
  FileContent content_;
  GmshGroups groups_;
  std::unordered_map<std::int64_t, Index> node_of_tag_;
  Version version_ = Version::kUnknown;
  bool has_nodes_ = false;
  bool has_elements_ = false;
};

}  // namespace

FileContent parse_gmsh(std::string_view bytes, const std::string& file_name) {
  return GmshParser(bytes, file_name).parse();
}

}  // namespace floe::mesh
