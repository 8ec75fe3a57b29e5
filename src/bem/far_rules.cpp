#include "bem/far_rules.hpp"

#include <floe/numeric/gauss_legendre.hpp>

#include <algorithm>
#include <cmath>

namespace floe::bem {
namespace {

// Error of n Gauss points for the product of e^{ikx} and a quadratic on [-a, a]: the remainder
// 2^{2n+1} (n!)^4 / ((2n+1) ((2n)!)^3) f^{(2n)} with f^{(2n)} ~ n(2n-1)·2·(ka)^{2n-2}
double wave_error(int n, double ka) {
  const double log_factor = (2 * n + 1) * std::log(2.0) + 4.0 * std::lgamma(n + 1.0) -
                            std::log(2 * n + 1.0) - 3.0 * std::lgamma(2 * n + 1.0);
  return std::exp(log_factor) * n * (2 * n - 1) * 2.0 * std::pow(ka, 2 * n - 2);
}

// Gap, in half edges, from which n points are enough (B.3). A target abreast of the cell, the least
// favourable place, puts a pole at ±i gap: the error is ρ^{-2n}, ρ = gap + √(gap²+1), and the
// quadratic shape function grows by ρ² on that ellipse
double smallest_gap(int n, double tolerance) {
  const double rho = std::pow(tolerance, -1.0 / (2 * n - 2));
  return 0.5 * (rho - 1.0 / rho);
}

// Largest ka that n points integrate: the error above, solved for ka
double largest_phase(int n, double tolerance) {
  return std::pow(tolerance / wave_error(n, 1.0), 1.0 / (2 * n - 2));
}

double half_longest(const ElementNodes& q) {
  double longest = std::max((q.col(5) - q.col(7)).norm(), (q.col(6) - q.col(4)).norm());
  for (int side = 0; side < 4; ++side)
    longest = std::max(longest, (q.col(side) - q.col((side + 1) % 4)).norm());
  return 0.5 * longest;
}

}  // namespace

FarRules::FarRules(const mesh::Q8Mesh& mesh, double tolerance)
    : centre_(2, mesh.element_count()),
      half_edge_(mesh.element_count()),
      radius_(mesh.element_count()) {
  for (int tier = 0; tier < kTiers; ++tier) {
    least_gap_[tier] = smallest_gap(kOrders[tier], tolerance);
    largest_phase_[tier] = largest_phase(kOrders[tier], tolerance);
  }

  for (Index e = 0; e < mesh.element_count(); ++e) {
    const ElementNodes nodes = mesh.element_nodes(e);
    centre_.col(e) = nodes * mesh::q8_shape(0.0, 0.0);
    half_edge_[e] = half_longest(nodes);
    radius_[e] = (nodes.colwise() - Point2(centre_.col(e))).colwise().norm().maxCoeff();
    for (int tier = 0; tier < kTiers; ++tier) {
      const auto& gauss = numeric::gauss_legendre(kOrders[tier]);
      for (int i = 0; i < kOrders[tier]; ++i)
        for (int j = 0; j < kOrders[tier]; ++j)
          rule_[tier].add(nodes, gauss.node[i], gauss.node[j], gauss.weight[i] * gauss.weight[j]);
    }
  }
}

int FarRules::tier_for_wave(double wavenumber, double half_edge) const {
  int tier = 0;
  while (tier < kTiers && wavenumber * half_edge > largest_phase_[tier]) ++tier;
  return tier;
}

int FarRules::tier_for_gap(double gap, double half_edge) const {
  int tier = 0;
  while (tier < kTiers && gap < least_gap_[tier] * half_edge) ++tier;
  return tier;
}

}  // namespace floe::bem
