#pragma once

#include <floe/numeric/types.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace floe::mesh {

/// Node indices of each element, one element a column, order as in shape_functions.hpp.
using Connectivity = Eigen::Matrix<Index, 8, Eigen::Dynamic>;

/// How nodes and elements are called in messages.
struct MeshLabels {
  std::vector<std::int64_t> nodes = {};  ///< tags in a file, or empty; 0: the file has no such node
  std::vector<std::int64_t> elements = {};  ///< tags in a file, or empty

  /// The tag, or the number from 1 where there are no tags.
  std::string node(Index node) const;
  std::string element(Index element) const;
};

/// A plane mesh of 8-node quadrilaterals on z = 0: validated, oriented counter-clockwise,
/// immutable. Several separate pieces (connected components) are allowed.
class Q8Mesh {
 public:
  /// Checks and takes over `nodes` (2 × N, [m]) and `elements` (8 × E, 0-based).
  /// Clockwise elements are turned; how many is told by `reoriented_count`.
  /// Throws MeshError naming the first ten culprits, by their labels, when: there is no element; a
  /// coordinate is not finite or beyond 1e9 m; an index is out of range or repeated within an
  /// element; a node is unused; det J has no single sign over an element's 3 × 3 Gauss points; two
  /// nodes coincide (to 1e-6 of the size, or 1e-3 of the median element if that is less); an
  /// element stands twice or elements overlap; an edge is shared by more than two elements or with
  /// another mid-side node; a node lies on an edge of an element that does not own it (T-junction,
  /// unmerged pieces); pieces share a node but no edge. Takes about half a microsecond a node.
  Q8Mesh(Points2 nodes, Connectivity elements, const MeshLabels& labels = {});

  Index node_count() const { return nodes_.cols(); }
  Index element_count() const { return elements_.cols(); }
  const Points2& nodes() const { return nodes_; }
  const Connectivity& elements() const { return elements_; }

  /// Coordinates of the eight nodes of one element, one a column [m].
  Eigen::Matrix<double, 2, 8> element_nodes(Index element) const;

  /// Largest extent of the bounding box [m]: the length to which tolerances are relative.
  double size() const { return size_; }
  Point2 lower() const { return lower_; }  ///< lower left corner of the bounding box [m]
  Point2 upper() const { return upper_; }  ///< upper right corner of the bounding box [m]
  double area() const { return area_; }    ///< [m²]

  /// Number of connected components, and the component (0-based) of each element and each node.
  /// Components are numbered in the order of their first element.
  int piece_count() const { return piece_count_; }
  const std::vector<int>& element_piece() const { return element_piece_; }
  const std::vector<int>& node_piece() const { return node_piece_; }

  Index reoriented_count() const { return reoriented_count_; }

 private:
  Points2 nodes_;
  Connectivity elements_;
  Point2 lower_, upper_;
  double size_ = 0.0;
  double area_ = 0.0;
  int piece_count_ = 0;
  std::vector<int> element_piece_;
  std::vector<int> node_piece_;
  Index reoriented_count_ = 0;
};

}  // namespace floe::mesh
