#include "mesh/geometry.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/overlap.hpp"
#include "mesh/pieces.hpp"
#include "mesh/validation.hpp"

#include <floe/mesh/q8_mesh.hpp>

#include <utility>

namespace floe::mesh {

std::string MeshLabels::node(Index node) const {
  if (nodes.empty()) return std::to_string(node + 1);
  const std::int64_t tag = nodes[static_cast<std::size_t>(node)];
  return tag > 0 ? std::to_string(tag) : "without a tag";
}

std::string MeshLabels::element(Index element) const {
  return std::to_string(elements.empty() ? element + 1
                                         : elements[static_cast<std::size_t>(element)]);
}

Q8Mesh::Q8Mesh(Points2 nodes, Connectivity elements, const MeshLabels& labels)
    : nodes_(std::move(nodes)), elements_(std::move(elements)) {
  // Check each element by itself
  check_arrays(nodes_, elements_, labels);
  nodes_.array() += 0.0;  // -0 becomes 0
  lower_ = nodes_.rowwise().minCoeff();
  upper_ = nodes_.rowwise().maxCoeff();
  size_ = (upper_ - lower_).maxCoeff();
  reoriented_count_ = orient_elements(nodes_, elements_, labels);

  // Check how they lie together
  const double tolerance = merge_tolerance(nodes_, elements_, size_);
  check_coincident_nodes(nodes_, tolerance, labels);
  check_duplicate_elements(nodes_, elements_, labels);
  const std::vector<HalfEdge> half_edges = sorted_half_edges(elements_);
  check_edges(nodes_, elements_, half_edges, labels);
  check_overlap(nodes_, elements_, half_edges, tolerance, labels);

  // Describe the whole
  Pieces pieces = find_pieces(nodes_, elements_, half_edges, labels);
  piece_count_ = pieces.count;
  element_piece_ = std::move(pieces.of_element);
  node_piece_ = std::move(pieces.of_node);
  for (Index e = 0; e < element_count(); ++e) area_ += signed_area(element_nodes(e));
}

Eigen::Matrix<double, 2, 8> Q8Mesh::element_nodes(Index element) const {
  return gather_nodes(nodes_, elements_, element);
}

}  // namespace floe::mesh
