#include "bem/quadrature_points.hpp"

#include <floe/numeric/simd.hpp>

#include <Eigen/LU>

#include <cmath>

namespace floe::bem {

namespace {

// The eight shape functions in the monomials 1 ξ η ξ² ξη η² ξ²η ξη²: N_m = Σ_k a(m, k) monomial_k
const Eigen::Matrix<double, 8, 8>& shape_coefficients() {
  static const Eigen::Matrix<double, 8, 8> coefficients = [] {
    Eigen::Matrix<double, 8, 8> at_nodes;  // monomial k at node m
    for (int m = 0; m < 8; ++m) {
      const double xi = mesh::q8_parametric_nodes()(0, m), eta = mesh::q8_parametric_nodes()(1, m);
      at_nodes.row(m) << 1.0, xi, eta, xi * xi, xi * eta, eta * eta, xi * xi * eta, xi * eta * eta;
    }
    return Eigen::Matrix<double, 8, 8>(at_nodes.inverse().transpose());
  }();
  return coefficients;
}

// x, y: coefficients of the two coordinates in the monomials
FLOE_SIMD_CLONES void map_points(const double* cx, const double* cy, std::size_t count,
                                 const double* xi, const double* eta, const double* weight,
                                 double* x, double* y, double* area, double* monomial) {
  for (std::size_t p = 0; p < count; ++p) {
    const double a = xi[p], b = eta[p], aa = a * a, ab = a * b, bb = b * b;
    x[p] = cx[0] + cx[1] * a + cx[2] * b + cx[3] * aa + cx[4] * ab + cx[5] * bb + cx[6] * aa * b +
           cx[7] * ab * b;
    y[p] = cy[0] + cy[1] * a + cy[2] * b + cy[3] * aa + cy[4] * ab + cy[5] * bb + cy[6] * aa * b +
           cy[7] * ab * b;
    const double xa = cx[1] + 2.0 * cx[3] * a + cx[4] * b + 2.0 * cx[6] * ab + cx[7] * bb;
    const double xb = cx[2] + cx[4] * a + 2.0 * cx[5] * b + cx[6] * aa + 2.0 * cx[7] * ab;
    const double ya = cy[1] + 2.0 * cy[3] * a + cy[4] * b + 2.0 * cy[6] * ab + cy[7] * bb;
    const double yb = cy[2] + cy[4] * a + 2.0 * cy[5] * b + cy[6] * aa + 2.0 * cy[7] * ab;
    area[p] = weight[p] * (xa * yb - ya * xb);
  }
  for (std::size_t p = 0; p < count; ++p) {
    const double a = xi[p], b = eta[p];
    double* const m = monomial + 8 * p;
    m[0] = 1.0;
    m[1] = a;
    m[2] = b;
    m[3] = a * a;
    m[4] = a * b;
    m[5] = b * b;
    m[6] = a * a * b;
    m[7] = a * b * b;
  }
}

}  // namespace

void QuadraturePoints::map(const ElementNodes& nodes) {
  for (auto* values : {&x, &y, &area}) values->resize(count());
  monomial.resize(8 * count());
  const Eigen::Matrix<double, 8, 2> coefficients =
      shape_coefficients().transpose() * nodes.transpose();
  map_points(coefficients.data(), coefficients.data() + 8, count(), xi.data(), eta.data(),
             parametric_weight.data(), x.data(), y.data(), area.data(), monomial.data());
}

FLOE_SIMD_CLONES void fill_distances(const Point2& target, const double* x, const double* y,
                                     std::size_t count, double* distance) {
  const double tx = target.x(), ty = target.y();
  for (std::size_t p = 0; p < count; ++p) {
    const double dx = x[p] - tx, dy = y[p] - ty;
    distance[p] = std::sqrt(dx * dx + dy * dy);
  }
}

FLOE_SIMD_CLONES void scale_values(const double* factor, std::size_t count, Complex* value) {
  double* v = reinterpret_cast<double*>(value);
  for (std::size_t p = 0; p < count; ++p) {
    v[2 * p] *= factor[p];
    v[2 * p + 1] *= factor[p];
  }
}

FLOE_SIMD_CLONES void sum_weighted(const double* weight, const Complex* value, std::size_t count,
                                   Complex* sum) {
  using Double8 = double __attribute__((vector_size(64)));
  const double* v = reinterpret_cast<const double*>(value);
  // Two independent sums each, so that the additions need not wait for one another
  Double8 re[2] = {}, im[2] = {};
  for (std::size_t p = 0; p < count; ++p) {
    Double8 w;
    __builtin_memcpy(&w, weight + 8 * p, sizeof(w));
    re[p % 2] += w * v[2 * p];
    im[p % 2] += w * v[2 * p + 1];
  }
  const Double8 real = re[0] + re[1], imaginary = im[0] + im[1];
  for (int m = 0; m < 8; ++m) sum[m] = Complex(real[m], imaginary[m]);
}

void QuadraturePoints::sum(Complex* value, Complex* sum) const {
  scale_values(area.data(), count(), value);
  Eigen::Matrix<Complex, 8, 1> moment;
  sum_weighted(monomial.data(), value, count(), moment.data());
  Eigen::Map<Eigen::Matrix<Complex, 8, 1>>(sum, 8) = shape_coefficients() * moment;
}

}  // namespace floe::bem
