#include "mesh/geometry.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/overlap.hpp"
#include "mesh/pieces.hpp"
#include "mesh/validation.hpp"

#include <floe/mesh/q8_mesh.hpp>

#include <utility>

namespace floe::mesh {

Q8Mesh::Q8Mesh(Points2 nodes, Connectivity elements)
    : nodes_(std::move(nodes)), elements_(std::move(elements)) {
  // Check each element by itself
  check_arrays(nodes_, elements_);
  nodes_.array() += 0.0;  // -0 becomes 0
  lower_ = nodes_.rowwise().minCoeff();
  upper_ = nodes_.rowwise().maxCoeff();
  size_ = (upper_ - lower_).maxCoeff();
  reoriented_count_ = orient_elements(nodes_, elements_);

  // Check how they lie together
  const double tolerance = merge_tolerance(nodes_, elements_, size_);
  check_coincident_nodes(nodes_, tolerance);
  check_duplicate_elements(nodes_, elements_);
  const std::vector<HalfEdge> half_edges = sorted_half_edges(elements_);
  check_edges(nodes_, elements_, half_edges);
  check_overlap(nodes_, elements_, half_edges, tolerance);

  // Describe the whole
  Pieces pieces = find_pieces(nodes_, elements_, half_edges);
  piece_count_ = pieces.count;
  element_piece_ = std::move(pieces.of_element);
  node_piece_ = std::move(pieces.of_node);
  for (Index e = 0; e < element_count(); ++e) area_ += signed_area(element_nodes(e));
}

Eigen::Matrix<double, 2, 8> Q8Mesh::element_nodes(Index element) const {
  return gather_nodes(nodes_, elements_, element);
}

}  // namespace floe::mesh
