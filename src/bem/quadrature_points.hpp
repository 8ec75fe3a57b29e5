#pragma once

#include <floe/mesh/shape_functions.hpp>
#include <floe/numeric/types.hpp>

#include <cstddef>
#include <vector>

namespace floe::bem {

using ElementNodes = Eigen::Matrix<double, 2, 8>;

/// Quadrature points of one element, collected in the parametric plane and then mapped all at once.
struct QuadraturePoints {
  std::vector<double> xi, eta, parametric_weight;  ///< the weight in dξ dη
  std::vector<double> x, y, area;  ///< after `map`: position [m], weight · det J [m²]
  std::vector<double> monomial;    ///< after `map`: 8 a point, 1 ξ η ξ² ξη η² ξ²η ξη²

  std::size_t count() const { return xi.size(); }
  void clear() {
    xi.clear();
    eta.clear();
    parametric_weight.clear();
  }
  void add(double at_xi, double at_eta, double weight) {
    xi.push_back(at_xi);
    eta.push_back(at_eta);
    parametric_weight.push_back(weight);
  }
  /// Fills positions, areas and monomials in an element of these nodes.
  void map(const ElementNodes& nodes);
  /// sum[m] = Σ_p area_p N_m(ξ_p, η_p) value[p], m = 0 … 7, of mapped points; scales the values.
  void sum(Complex* value, Complex* sum) const;
};

/// value[p] *= factor[p].
void scale_values(const double* factor, std::size_t count, Complex* value);

/// Distances |target - (x_p, y_p)| of `count` points.
void fill_distances(const Point2& target, const double* x, const double* y, std::size_t count,
                    double* distance);

/// sum[m] = Σ_p weight[8p + m] value[p], m = 0 … 7.
void sum_weighted(const double* weight, const Complex* value, std::size_t count, Complex* sum);

}  // namespace floe::bem
