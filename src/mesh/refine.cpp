#include <floe/mesh/refine.hpp>
#include <floe/mesh/shape_functions.hpp>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace floe::mesh {
namespace {

using Nodes8 = Eigen::Matrix<double, 2, 8>;

// Adds nodes to those of a coarse mesh; the quarter points of a side are shared with its neighbour
class FinerNodes {
 public:
  explicit FinerNodes(const Q8Mesh& mesh) : mesh_(mesh), node_(mesh.nodes().cols()) {
    for (Index n = 0; n < mesh.node_count(); ++n) node_[n] = mesh.nodes().col(n);
  }

  // The point of an element at (ξ, η)
  Index add(Index element, double xi, double eta) {
    node_.push_back(mesh_.element_nodes(element) * q8_shape(xi, eta));
    return static_cast<Index>(node_.size()) - 1;
  }

  // The point of side `side`, a quarter of it away from `corner`
  Index quarter(Index element, int side, int corner) {
    const auto& elements = mesh_.elements();
    const std::pair key(elements(corner, element), elements(4 + side, element));
    const auto known = quarter_.find(key);
    if (known != quarter_.end()) return known->second;
    const Nodes8& at = q8_parametric_nodes();
    const Point2 between = 0.5 * (at.col(corner) + at.col(4 + side));
    return quarter_[key] = add(element, between.x(), between.y());
  }

  Points2 all() const {
    Points2 nodes(2, static_cast<Index>(node_.size()));
    for (std::size_t n = 0; n < node_.size(); ++n) nodes.col(static_cast<Index>(n)) = node_[n];
    return nodes;
  }

 private:
  const Q8Mesh& mesh_;  // view
  std::vector<Point2> node_;
  std::map<std::pair<Index, Index>, Index> quarter_;  // by corner and mid-side node
};

}  // namespace

Q8Mesh refine(const Q8Mesh& mesh) {
  FinerNodes nodes(mesh);
  Connectivity elements(8, 4 * mesh.element_count());
  const Nodes8& at = q8_parametric_nodes();
  for (Index e = 0; e < mesh.element_count(); ++e) {
    // Nodes inside: the centre, and those halfway to the middle of each side
    const Index centre = nodes.add(e, 0.0, 0.0);
    std::array<Index, 4> halfway;
    for (int side = 0; side < 4; ++side)
      halfway[side] = nodes.add(e, 0.5 * at(0, 4 + side), 0.5 * at(1, 4 + side));

    // The part at each corner, from the corner on counter-clockwise
    for (int corner = 0; corner < 4; ++corner) {
      const int next = corner, last = (corner + 3) % 4;  // the sides that meet at the corner
      elements.col(4 * e + corner) << mesh.elements()(corner, e), mesh.elements()(4 + next, e),
          centre, mesh.elements()(4 + last, e), nodes.quarter(e, next, corner), halfway[next],
          halfway[last], nodes.quarter(e, last, corner);
    }
  }
  return Q8Mesh(nodes.all(), std::move(elements));
}

}  // namespace floe::mesh
