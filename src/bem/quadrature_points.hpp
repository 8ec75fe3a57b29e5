#pragma once

#include <floe/green/green_table.hpp>
#include <floe/mesh/shape_functions.hpp>
#include <floe/numeric/types.hpp>

#include <cstddef>
#include <vector>

namespace floe::bem {

using ElementNodes = Eigen::Matrix<double, 2, 8>;

/// Quadrature points of one element: where they lie, and the eight shape functions there times the
/// weight and the Jacobian.
struct QuadraturePoints {
  std::vector<double> x, y;    ///< [m]
  std::vector<double> weight;  ///< 8 a point, weight · det J · N_m [m²]

  std::size_t count() const { return x.size(); }
  void clear() {
    x.clear();
    y.clear();
    weight.clear();
  }
  /// Adds the point (ξ, η) of an element; `parametric_weight` is the weight in dξ dη.
  void add(const ElementNodes& nodes, double xi, double eta, double parametric_weight);
};

/// Scratch of one thread.
struct KernelBuffer {
  std::vector<double> distance;
  std::vector<Complex> value;
};

/// sum[m] = Σ_p weight[8p + m] G(|target - (x_p, y_p)|), m = 0 … 7. All distances must be positive.
void sum_kernel(const Point2& target, const double* x, const double* y, const double* weight,
                std::size_t count, const green::GreenTable& green, KernelBuffer& buffer,
                Complex* sum);

/// value[p] *= factor[p].
void scale_values(const double* factor, std::size_t count, Complex* value);

/// Distances |target - (x_p, y_p)| of `count` points.
void fill_distances(const Point2& target, const double* x, const double* y, std::size_t count,
                    double* distance);

/// sum[m] = Σ_p weight[8p + m] value[p], m = 0 … 7.
void sum_weighted(const double* weight, const Complex* value, std::size_t count, Complex* sum);

}  // namespace floe::bem
