#include "mesh/validation.hpp"

#include "mesh/culprits.hpp"
#include "mesh/geometry.hpp"

#include <floe/numeric/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

namespace floe::mesh {
namespace {

constexpr double kLargestCoordinate = 1e9;  // [m]
constexpr double kSmallestSize = 1e-6;      // [m]
// Coordinates relative to the size, beyond which too few digits are left within the mesh
constexpr double kFarthest = 1e7;
// Least det J relative to the square of the element's extent: rounding of collinear nodes
constexpr double kSmallestJacobian = 1e-10;
// Least tolerance relative to the size: what rounding leaves of coordinates
constexpr double kLeastTolerance = 1e-14;

void check_coordinates(const Points2& nodes, const MeshLabels& labels) {
  Culprits culprits;
  for (Index n = 0; n < nodes.cols(); ++n)
    if (!(nodes.col(n).cwiseAbs().maxCoeff() <= kLargestCoordinate) || !nodes.col(n).allFinite())
      culprits.add("node ", labels.node(n), " at ", at(nodes.col(n)));
  culprits.throw_if_any("nodes with unusable coordinates",
                        "coordinates must be finite, 1e9 m at most");
}

void check_indices(Index node_count, const Connectivity& elements, const MeshLabels& labels) {
  Culprits outside, repeated;
  for (Index e = 0; e < elements.cols(); ++e) {
    std::array<Index, 8> index;
    std::copy_n(elements.col(e).data(), 8, index.begin());
    std::sort(index.begin(), index.end());
    if (index.front() < 0 || index.back() >= node_count)
      outside.add("element ", labels.element(e), " has node ",
                  (index.front() < 0 ? index.front() : index.back()) + 1);
    const auto twice = std::adjacent_find(index.begin(), index.end());
    if (twice != index.end())
      repeated.add("element ", labels.element(e), " has node ", labels.node(*twice), " twice");
  }
  outside.throw_if_any("elements with a node out of range",
                       "nodes are numbered 1 to " + std::to_string(node_count));
  repeated.throw_if_any("elements with a repeated node", "eight nodes must differ");
}

void check_all_nodes_used(const Points2& nodes, const Connectivity& elements,
                          const MeshLabels& labels) {
  std::vector<bool> used(nodes.cols(), false);
  for (const Index n : elements.reshaped()) used[n] = true;
  Culprits culprits;
  for (Index n = 0; n < nodes.cols(); ++n)
    if (!used[n]) culprits.add("node ", labels.node(n), " at ", at(nodes.col(n)));
  culprits.throw_if_any("unused nodes", "every node must belong to an element");
}

// Smallest and largest det J over the 3 × 3 Gauss points [m²]
struct JacobianRange {
  double smallest;
  double largest;
};

JacobianRange jacobian_range(const ElementNodes& points) {
  JacobianRange range{INFINITY, -INFINITY};
  for (const double determinant : gauss_point_jacobians(points)) {
    range.smallest = std::min(range.smallest, determinant);
    range.largest = std::max(range.largest, determinant);
  }
  return range;
}

// The same element, run through the other way round
void turn(Connectivity& elements, Index e) {
  std::swap(elements(1, e), elements(3, e));
  std::swap(elements(4, e), elements(7, e));
  std::swap(elements(5, e), elements(6, e));
}

// A node in its square of a grid of tolerance-sized cells
struct Cell {
  std::int64_t row;
  std::int64_t column;
  Index node;

  bool operator<(const Cell& other) const {
    return std::tie(row, column, node) < std::tie(other.row, other.column, other.node);
  }
};

}  // namespace

void check_arrays(const Points2& nodes, const Connectivity& elements, const MeshLabels& labels) {
  FLOE_VALIDATE_AS(MeshError, elements.cols() > 0,
                   "invalid mesh: elements = 0 (must be at least 1)");
  check_coordinates(nodes, labels);
  check_indices(nodes.cols(), elements, labels);
  check_all_nodes_used(nodes, elements, labels);
  const double size = (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).maxCoeff();
  FLOE_VALIDATE_AS(
      MeshError, size >= kSmallestSize,
      "invalid mesh: size = " << size << " m (must be at least " << kSmallestSize << ")");
  const double farthest = nodes.cwiseAbs().maxCoeff();
  FLOE_VALIDATE_AS(MeshError, farthest <= kFarthest * size,
                   "invalid mesh: largest coordinate = "
                       << farthest << " m (must be at most 1e7 times the size, which is " << size
                       << " m: shift the mesh to the origin)");
}

Index orient_elements(const Points2& nodes, Connectivity& elements, const MeshLabels& labels) {
  Index turned = 0;
  Culprits culprits;
  for (Index e = 0; e < elements.cols(); ++e) {
    const ElementNodes points = gather_nodes(nodes, elements, e);
    const double extent = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
    const double least = kSmallestJacobian * extent * extent;
    const JacobianRange range = jacobian_range(points);
    if (range.smallest > least) continue;
    if (range.largest < -least) {
      turn(elements, e);
      ++turned;
      continue;
    }
    culprits.add("element ", labels.element(e), " at ", at(points.leftCols<4>().rowwise().mean()),
                 ": det J = ", range.smallest, " to ", range.largest, " m²");
  }
  culprits.throw_if_any("degenerate or folded elements",
                        "det J must have one sign at every Gauss point");
  return turned;
}

double merge_tolerance(const Points2& nodes, const Connectivity& elements, double size) {
  std::vector<double> extent(elements.cols());
  for (Index e = 0; e < elements.cols(); ++e) {
    const ElementNodes points = gather_nodes(nodes, elements, e);
    extent[e] = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
  }
  const auto median = extent.begin() + static_cast<std::ptrdiff_t>(extent.size() / 2);
  std::nth_element(extent.begin(), median, extent.end());
  return std::max(std::min(kRelativeTolerance * size, 1e-3 * *median), kLeastTolerance * size);
}

void check_coincident_nodes(const Points2& nodes, double tolerance, const MeshLabels& labels) {
  // Sort the nodes into cells, row by row
  const Point2 lower = nodes.rowwise().minCoeff();
  std::vector<Cell> cells(nodes.cols());
  for (Index n = 0; n < nodes.cols(); ++n) {
    const Point2 scaled = (nodes.col(n) - lower) / tolerance;
    cells[n] = {static_cast<std::int64_t>(scaled.y()), static_cast<std::int64_t>(scaled.x()), n};
  }
  std::sort(cells.begin(), cells.end());

  // Compare each node with those behind it: its own row, then three cells of the next row
  Culprits culprits;
  const auto find_partner = [&](const Cell& cell, std::size_t from, std::int64_t row) {
    for (std::size_t i = from; i < cells.size(); ++i) {
      const Cell& other = cells[i];
      if (other.row != row || other.column > cell.column + 1) return false;
      if ((nodes.col(cell.node) - nodes.col(other.node)).norm() > tolerance) continue;
      culprits.add("nodes ", labels.node(std::min(cell.node, other.node)), " and ",
                   labels.node(std::max(cell.node, other.node)), " at ", at(nodes.col(cell.node)));
      return true;
    }
    return false;
  };
  std::size_t next_row = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell reach{cells[i].row + 1, cells[i].column - 1, -1};
    while (next_row < cells.size() && cells[next_row] < reach) ++next_row;
    if (!find_partner(cells[i], i + 1, cells[i].row))
      find_partner(cells[i], next_row, cells[i].row + 1);
  }
  culprits.throw_if_any("coincident nodes", "nodes at one place must be merged");
}

}  // namespace floe::mesh
