#include "mesh/file_content.hpp"

#include "mesh/geometry.hpp"

#include <floe/numeric/error.hpp>

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <unordered_map>
#include <utility>

namespace floe::mesh {
namespace {

// "1 node", "2 nodes"
std::string counted(Index count, const std::string& singular) {
  return std::to_string(count) + " " + singular + (count == 1 ? "" : "s");
}

// The quads of a file as columns of eight nodes, numbered without gaps; -1 is a mid-side node that
// a 4-node quad does not have
struct Quads {
  std::vector<Eigen::Vector3d> nodes;
  Connectivity elements;
  MeshLabels labels;
  Index raised = 0;        // quads with 4 nodes
  Index centre_nodes = 0;  // dropped with their quads' ninth node
  Index unused_nodes = 0;  // dropped, no quad has them
};

Quads gather_quads(const FileContent& content) {
  Quads quads;
  quads.elements.resize(8, static_cast<Index>(content.quads.size()));
  constexpr Index kUnused = -1, kCentre = -2, kUsed = 0;
  std::vector<Index> number(content.coordinates.size(), kUnused);
  for (const FileQuad& quad : content.quads) {
    for (int a = 0; a < std::min(quad.node_count, 8); ++a) number[quad.nodes[a]] = kUsed;
    if (quad.node_count == 4) ++quads.raised;
    if (quad.node_count == 9 && number[quad.nodes[8]] == kUnused) number[quad.nodes[8]] = kCentre;
  }
  for (std::size_t n = 0; n < number.size(); ++n) {
    if (number[n] == kUnused) ++quads.unused_nodes;
    if (number[n] == kCentre) ++quads.centre_nodes;
    if (number[n] != kUsed) continue;
    number[n] = static_cast<Index>(quads.nodes.size());
    quads.nodes.push_back(content.coordinates[n]);
    if (!content.tags.empty()) quads.labels.nodes.push_back(content.tags[n]);
  }
  for (Index e = 0; e < quads.elements.cols(); ++e) {
    const FileQuad& quad = content.quads[e];
    for (int a = 0; a < 8; ++a)
      quads.elements(a, e) = a < quad.node_count ? number[quad.nodes[a]] : -1;
    if (quad.tag > 0) quads.labels.elements.push_back(quad.tag);
  }
  return quads;
}

// Gives 4-node quads the mid-side nodes of their neighbours, or new ones on straight edges
void raise_to_eight_nodes(Quads& quads) {
  using EdgeKey = std::pair<Index, Index>;
  struct EdgeHash {
    std::size_t operator()(const EdgeKey& key) const {
      const auto low = static_cast<std::uint64_t>(key.first);
      return static_cast<std::size_t>((low * 0x9e3779b97f4a7c15ULL) ^
                                      static_cast<std::uint64_t>(key.second));
    }
  };
  std::unordered_map<EdgeKey, Index, EdgeHash> middle_of_edge;
  const auto edge_key = [&](Index e, int side) {
    return EdgeKey(std::minmax(quads.elements(side, e), quads.elements((side + 1) % 4, e)));
  };
  for (Index e = 0; e < quads.elements.cols(); ++e)
    for (int side = 0; side < 4; ++side)
      if (quads.elements(4 + side, e) >= 0)
        middle_of_edge.emplace(edge_key(e, side), quads.elements(4 + side, e));
  for (Index e = 0; e < quads.elements.cols(); ++e)
    for (int side = 0; side < 4; ++side) {
      if (quads.elements(4 + side, e) >= 0) continue;
      const EdgeKey key = edge_key(e, side);
      const auto [edge, is_new] =
          middle_of_edge.emplace(key, static_cast<Index>(quads.nodes.size()));
      if (is_new) quads.nodes.push_back(0.5 * (quads.nodes[key.first] + quads.nodes[key.second]));
      quads.elements(4 + side, e) = edge->second;
    }
}

// The nodes in the plane z = 0; throws if they do not lie there
Points2 plane_nodes(const std::vector<Eigen::Vector3d>& nodes) {
  Eigen::Vector3d lower = nodes.front(), upper = nodes.front();
  for (const Eigen::Vector3d& node : nodes) {
    lower = lower.cwiseMin(node);
    upper = upper.cwiseMax(node);
  }
  const double tolerance = kRelativeTolerance * (upper - lower).head<2>().maxCoeff();
  const bool level = upper.z() - lower.z() <= tolerance;
  FLOE_VALIDATE_AS(MeshError, std::max(upper.z(), -lower.z()) <= tolerance,
                   "invalid z = " << lower.z() << " to " << upper.z()
                                  << " m (must be 0, to 1e-6 of the size: "
                                  << (level ? "shift the mesh to the water plane z = 0)"
                                            : "turn and shift the mesh into the plane z = 0)"));
  Points2 plane(2, static_cast<Index>(nodes.size()));
  for (Index n = 0; n < plane.cols(); ++n) plane.col(n) = nodes[n].head<2>();
  return plane;
}

void refuse_other_elements(const FileContent& content) {
  std::ostringstream found;
  for (const auto& [name, count] : content.refused)
    found << (found.tellp() > 0 ? ", " : "") << count << " " << name;
  FLOE_VALIDATE_AS(
      MeshError, content.refused.empty(),
      "invalid elements = " << found.str() << " (must be quadrilaterals with 4, 8 or 9 nodes)");
  FLOE_VALIDATE_AS(MeshError, !content.quads.empty(),
                   "invalid quadrilaterals = 0 (must be at least 1; found "
                       << counted(content.point_elements, "point element") << " and "
                       << counted(content.line_elements, "line element") << ")");
}

std::vector<std::string> make_notices(const FileContent& content, const Quads& quads) {
  std::vector<std::string> notices;
  if (content.point_elements + content.line_elements + quads.unused_nodes > 0)
    notices.push_back("dropped " + counted(content.point_elements, "point element") + ", " +
                      counted(content.line_elements, "line element") + " and " +
                      counted(quads.unused_nodes, "node") + " that no quadrilateral uses");
  if (quads.centre_nodes > 0)
    notices.push_back("dropped " + counted(quads.centre_nodes, "centre node") +
                      " of quadrilaterals with 9 nodes");
  if (quads.raised > 0)
    notices.push_back("gave mid-side nodes to " + counted(quads.raised, "quadrilateral") +
                      " with 4 nodes");
  return notices;
}

}  // namespace

MeshFile make_mesh_file(const FileContent& content, const std::string& file_name) {
  try {
    refuse_other_elements(content);
    Quads quads = gather_quads(content);
    if (quads.raised > 0) raise_to_eight_nodes(quads);
    if (!quads.labels.nodes.empty()) quads.labels.nodes.resize(quads.nodes.size(), 0);
    if (quads.labels.elements.size() != content.quads.size()) quads.labels.elements.clear();
    std::vector<std::string> notices = make_notices(content, quads);
    return {Q8Mesh(plane_nodes(quads.nodes), std::move(quads.elements), quads.labels),
            std::move(notices), content.groups};
  } catch (const MeshError& error) {
    throw MeshError(file_name + ": " + error.what());
  }
}

}  // namespace floe::mesh
