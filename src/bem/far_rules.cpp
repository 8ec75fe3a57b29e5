#include "bem/far_rules.hpp"

#include "bem/quadrature_points.hpp"

#include <floe/mesh/shape_functions.hpp>
#include <floe/numeric/gauss_legendre.hpp>
#include <floe/numeric/simd.hpp>

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

// Points a direction of the transformed singular integrals: 10 reach 1.5e-8 on a curved element of
// a third of a radian, each point less costs about a digit
int singular_order_for(double tolerance) {
  return std::clamp(4 + static_cast<int>(std::ceil(-std::log10(tolerance) - 1e-9)), 6, 12);
}

double half_longest(const ElementNodes& q) {
  double longest = std::max((q.col(5) - q.col(7)).norm(), (q.col(6) - q.col(4)).norm());
  for (int side = 0; side < 4; ++side)
    longest = std::max(longest, (q.col(side) - q.col((side + 1) % 4)).norm());
  return 0.5 * longest;
}

// Positions and areas of the points of a rule in an element
FLOE_SIMD_CLONES void map_points(const ReferenceRule& rule, const double* nodes, double* x,
                                 double* y, double* area) {
  for (int p = 0; p < rule.size; ++p) {
    double px = 0.0, py = 0.0, x_xi = 0.0, y_xi = 0.0, x_eta = 0.0, y_eta = 0.0;
    for (int m = 0; m < 8; ++m) {
      const int at = m * rule.size + p;
      px += rule.shape[at] * nodes[2 * m];
      py += rule.shape[at] * nodes[2 * m + 1];
      x_xi += rule.d_xi[at] * nodes[2 * m];
      y_xi += rule.d_xi[at] * nodes[2 * m + 1];
      x_eta += rule.d_eta[at] * nodes[2 * m];
      y_eta += rule.d_eta[at] * nodes[2 * m + 1];
    }
    x[p] = px;
    y[p] = py;
    area[p] = rule.weight[p] * (x_xi * y_eta - y_xi * x_eta);
  }
}

}  // namespace

ReferenceRule::ReferenceRule(int order) : size(order * order) {
  for (auto* rows : {&shape, &d_xi, &d_eta, &shape_at_point}) rows->resize(8 * size);
  weight.resize(size);
  const auto& gauss = numeric::gauss_legendre(order);
  for (int p = 0; p < size; ++p) {
    const double xi = gauss.node[p / order], eta = gauss.node[p % order];
    const mesh::Shape8 value = mesh::q8_shape(xi, eta);
    const mesh::ShapeGradient8 gradient = mesh::q8_shape_gradient(xi, eta);
    weight[p] = gauss.weight[p / order] * gauss.weight[p % order];
    for (int m = 0; m < 8; ++m) {
      shape[m * size + p] = shape_at_point[8 * p + m] = value[m];
      d_xi[m * size + p] = gradient(0, m);
      d_eta[m * size + p] = gradient(1, m);
    }
  }
}

FarRules::FarRules(const mesh::Q8Mesh& mesh, double tolerance)
    : centre_(2, mesh.element_count()),
      singular_order_(singular_order_for(tolerance)),
      half_edge_(mesh.element_count()),
      radius_(mesh.element_count()),
      mesh_(mesh) {
  for (int tier = 0; tier < kTiers; ++tier) {
    least_gap_[tier] = smallest_gap(kOrders[tier], tolerance);
    largest_phase_[tier] = largest_phase(kOrders[tier], tolerance);
    reference_[tier] = ReferenceRule(kOrders[tier]);
  }
  for (int tier = 0; tier < kStoredTiers; ++tier)
    stored_[tier].resize(3 * static_cast<std::size_t>(size(tier) * mesh.element_count()));

  for (Index e = 0; e < mesh.element_count(); ++e) {
    const ElementNodes nodes = mesh.element_nodes(e);
    centre_.col(e) = nodes * mesh::q8_shape(0.0, 0.0);
    half_edge_[e] = half_longest(nodes);
    radius_[e] = (nodes.colwise() - Point2(centre_.col(e))).colwise().norm().maxCoeff();
    for (int tier = 0; tier < kStoredTiers; ++tier) {
      double* at = stored_[tier].data() + 3 * size(tier) * e;
      map_points(reference_[tier], nodes.data(), at, at + size(tier), at + 2 * size(tier));
    }
  }
}

void ReferenceRule::map(const double* nodes, double* x, double* y, double* area) const {
  map_points(*this, nodes, x, y, area);
}

void FarRules::fill_points(int tier, Index element, double* x, double* y, double* area) const {
  const int count = size(tier);
  if (tier >= kStoredTiers) {
    map_points(reference_[tier], mesh_.element_nodes(element).data(), x, y, area);
    return;
  }
  const double* at = stored_[tier].data() + 3 * count * element;
  std::copy_n(at, count, x);
  std::copy_n(at + count, count, y);
  std::copy_n(at + 2 * count, count, area);
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
