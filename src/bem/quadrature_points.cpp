#include "bem/quadrature_points.hpp"

#include <floe/numeric/simd.hpp>

#include <Eigen/LU>

#include <cmath>

namespace floe::bem {

void QuadraturePoints::add(const ElementNodes& nodes, double xi, double eta,
                           double parametric_weight) {
  const mesh::Shape8 shape = mesh::q8_shape(xi, eta);
  const Point2 position = nodes * shape;
  const Eigen::Matrix2d jacobian = mesh::q8_shape_gradient(xi, eta) * nodes.transpose();
  const double area = parametric_weight * jacobian.determinant();
  x.push_back(position.x());
  y.push_back(position.y());
  for (int m = 0; m < 8; ++m) weight.push_back(area * shape[m]);
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

void sum_kernel(const Point2& target, const double* x, const double* y, const double* weight,
                std::size_t count, const green::GreenTable& green, KernelBuffer& buffer,
                Complex* sum) {
  buffer.distance.resize(count);
  buffer.value.resize(count);
  fill_distances(target, x, y, count, buffer.distance.data());
  green.evaluate(buffer.distance, buffer.value);
  sum_weighted(weight, buffer.value.data(), count, sum);
}

}  // namespace floe::bem
