#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <array>
#include <vector>

namespace floe::bem {

/// A tensor Gauss rule on [-1, 1]², its functions as rows over the points.
struct ReferenceRule {
  explicit ReferenceRule(int order = 1);

  /// Positions [m] and areas [m²] of the points in an element of these nodes (x, y of each).
  void map(const double* nodes, double* x, double* y, double* area) const;

  int size;
  std::vector<double> shape;           ///< 8 × size
  std::vector<double> d_xi, d_eta;     ///< 8 × size
  std::vector<double> weight;          ///< size
  std::vector<double> shape_at_point;  ///< size × 8: the transpose of `shape`
};

/// Tensor Gauss rules of several orders for every element of a mesh, and the rule that says which
/// order a distance needs. Keeps a view of the mesh. The points of low orders, which the far
/// elements use, are stored: 700 bytes an element.
class FarRules {
 public:
  static constexpr std::array<int, 7> kOrders{2, 3, 4, 5, 6, 8, 12};
  static constexpr int kTiers = static_cast<int>(kOrders.size());
  /// Answer of the tier functions where even the highest order does not do: subdivide.
  static constexpr int kTooNear = kTiers;
  static constexpr int kStoredTiers = 3;

  FarRules(const mesh::Q8Mesh& mesh, double tolerance);

  Point2 centre(Index element) const { return centre_.col(element); }
  /// Half the longest of the four edges and two mid-lines [m].
  double half_edge(Index element) const { return half_edge_[element]; }
  /// Largest distance of a node from the centre [m].
  double radius(Index element) const { return radius_[element]; }

  /// First tier whose order integrates e^{ikx} times a shape function over a cell of that half
  /// edge.
  int tier_for_wave(double wavenumber, double half_edge) const;
  /// First tier good for a target whose distance from the cell is `gap`.
  int tier_for_gap(double gap, double half_edge) const;
  /// Gauss points a direction that an element holding its target needs (B.5)–(B.7).
  int singular_order() const { return singular_order_; }
  /// Smallest gap / half edge at which tier `tier` is good.
  double least_gap(int tier) const { return least_gap_[tier]; }

  /// Points of a rule.
  static constexpr int size(int tier) { return kOrders[tier] * kOrders[tier]; }

  /// Positions [m] and areas [m²] of the points of one element, size(tier) numbers each.
  void fill_points(int tier, Index element, double* x, double* y, double* area) const;

  /// The eight shape functions at each point of a tier, the same for all elements.
  const double* shape(int tier) const { return reference_[tier].shape_at_point.data(); }

 private:
  Points2 centre_;
  int singular_order_;
  VecXd half_edge_, radius_;
  std::array<double, kTiers> least_gap_{};      // in half edges
  std::array<double, kTiers> largest_phase_{};  // ka
  std::array<ReferenceRule, kTiers> reference_;
  const mesh::Q8Mesh& mesh_;                              // view
  std::array<std::vector<double>, kStoredTiers> stored_;  // x, y, area of all points of an element
};

}  // namespace floe::bem
