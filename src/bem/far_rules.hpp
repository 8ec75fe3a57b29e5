#pragma once

#include "bem/quadrature_points.hpp"

#include <floe/mesh/q8_mesh.hpp>

#include <array>
#include <vector>

namespace floe::bem {

/// Tensor Gauss rules of several orders for every element of a mesh, and the rule that says which
/// order a distance needs.
class FarRules {
 public:
  static constexpr std::array<int, 7> kOrders{2, 3, 4, 5, 6, 8, 12};
  static constexpr int kTiers = static_cast<int>(kOrders.size());
  /// Answer of the tier functions where even the highest order does not do: subdivide.
  static constexpr int kTooNear = kTiers;

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
  /// Smallest gap / half edge at which tier `tier` is good.
  double least_gap(int tier) const { return least_gap_[tier]; }

  const double* x(int tier, Index element) const {
    return rule_[tier].x.data() + element * size(tier);
  }
  const double* y(int tier, Index element) const {
    return rule_[tier].y.data() + element * size(tier);
  }
  const double* weight(int tier, Index element) const {
    return rule_[tier].weight.data() + 8 * element * size(tier);
  }
  /// Points of a rule.
  static int size(int tier) { return kOrders[tier] * kOrders[tier]; }

 private:
  Points2 centre_;
  VecXd half_edge_, radius_;
  std::array<double, kTiers> least_gap_{};      // in half edges
  std::array<double, kTiers> largest_phase_{};  // ka
  std::array<QuadraturePoints, kTiers> rule_;
};

}  // namespace floe::bem
