#pragma once

#include <vector>

namespace floe::numeric {

/// Nodes and weights of a quadrature on [-1, 1].
struct QuadratureRule {
  std::vector<double> node;
  std::vector<double> weight;
};

/// Gauss–Legendre rule with `count` points (1 … 64), exact for polynomials of degree 2·count - 1.
/// Newton on the Legendre recurrence; nodes and weights are right to 2e-15.
const QuadratureRule& gauss_legendre(int count);

}  // namespace floe::numeric
