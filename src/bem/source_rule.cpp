#include "bem/source_rule.hpp"

#include "bem/far_rules.hpp"
#include "bem/quadrature_points.hpp"

#include <floe/mesh/shape_functions.hpp>

#include <algorithm>

namespace floe::bem {
namespace {

int gauss_order(SourcePoints kind) {
  return kind == SourcePoints::kGauss3   ? 3
         : kind == SourcePoints::kGauss4 ? 4
         : kind == SourcePoints::kGauss5 ? 5
                                         : 6;
}

// Charges of one element at its Gauss points
inline void spread_element(const Complex* local, const double* shape, const double* area, int count,
                           Complex* charge) {
  for (int p = 0; p < count; ++p) {
    double re = 0.0, im = 0.0;
    for (int m = 0; m < 8; ++m) {
      re += shape[8 * p + m] * local[m].real();
      im += shape[8 * p + m] * local[m].imag();
    }
    charge[p] = Complex(area[p] * re, area[p] * im);
  }
}

}  // namespace

SourceRule::SourceRule(const mesh::Q8Mesh& mesh, SourcePoints kind)
    : kind_(kind), elements_(mesh.elements()) {
  if (at_nodes())
    place_at_nodes(mesh);
  else
    place_at_gauss_points(mesh, gauss_order(kind));
}

void SourceRule::place_at_nodes(const mesh::Q8Mesh& mesh) {
  // 3 × 3 Gauss points integrate the products of two shape functions exactly where det J is linear
  points_ = mesh.nodes();
  const ReferenceRule rule(3);
  std::vector<double> x(rule.size), y(rule.size), area(rule.size);
  element_mass_.resize(64, mesh.element_count());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(64 * static_cast<std::size_t>(mesh.element_count()));
  for (Index e = 0; e < mesh.element_count(); ++e) {
    rule.map(mesh.element_nodes(e).data(), x.data(), y.data(), area.data());
    Eigen::Matrix<double, 8, 8> mass = Eigen::Matrix<double, 8, 8>::Zero();
    for (int p = 0; p < rule.size; ++p) {
      const Eigen::Map<const mesh::Shape8> shape(rule.shape_at_point.data() + 8 * p);
      mass += area[p] * shape * shape.transpose();
    }
    element_mass_.col(e) = mass.reshaped();
    for (int a = 0; a < 8; ++a)
      for (int b = 0; b < 8; ++b)
        entries.emplace_back(static_cast<int>(elements_(a, e)), static_cast<int>(elements_(b, e)),
                             mass(a, b));
  }
  mass_.resize(mesh.node_count(), mesh.node_count());
  mass_.setFromTriplets(entries.begin(), entries.end());
}

void SourceRule::place_at_gauss_points(const mesh::Q8Mesh& mesh, int order) {
  const ReferenceRule rule(order);
  per_element_ = rule.size;
  shape_ = rule.shape_at_point;
  points_.resize(2, per_element_ * mesh.element_count());
  area_.resize(points_.cols());
  std::vector<double> x(rule.size), y(rule.size);
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Index first = per_element_ * e;
    rule.map(mesh.element_nodes(e).data(), x.data(), y.data(), area_.data() + first);
    for (int p = 0; p < rule.size; ++p) points_.col(first + p) << x[p], y[p];
  }
}

void SourceRule::collect(Index element, Complex* value, Complex* sum) const {
  if (at_nodes()) {
    sum_weighted(element_mass_.col(element).data(), value, 8, sum);
    return;
  }
  scale_values(area_.data() + per_element_ * element, per_element_, value);
  sum_weighted(shape_.data(), value, per_element_, sum);
}

void SourceRule::spread(const Eigen::Ref<const MatXcd>& values, Eigen::Ref<MatXcd> charges) const {
  for (Index column = 0; column < values.cols(); ++column) {
    const Complex* const value = values.col(column).data();
    Complex* const charge = charges.col(column).data();
    if (at_nodes()) {
#pragma omp parallel for schedule(static)
      for (Index row = 0; row < mass_.rows(); ++row) {
        Complex sum(0.0, 0.0);
        for (int k = mass_.outerIndexPtr()[row]; k < mass_.outerIndexPtr()[row + 1]; ++k)
          sum += mass_.valuePtr()[k] * value[mass_.innerIndexPtr()[k]];
        charge[row] = sum;
      }
      continue;
    }
#pragma omp parallel for schedule(static)
    for (Index e = 0; e < elements_.cols(); ++e) {
      Complex local[8];
      for (int m = 0; m < 8; ++m) local[m] = value[elements_(m, e)];
      spread_element(local, shape_.data(), area_.data() + per_element_ * e, per_element_,
                     charge + per_element_ * e);
    }
  }
}

double SourceRule::memory() const {
  return 8.0 * static_cast<double>(elements_.size() + points_.size() + element_mass_.size() +
                                   static_cast<Index>(area_.size())) +
         12.0 * static_cast<double>(mass_.nonZeros());
}

}  // namespace floe::bem
