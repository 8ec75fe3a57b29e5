#include <floe/hydro/surface_integrals.hpp>
#include <floe/mesh/shape_functions.hpp>
#include <floe/numeric/error.hpp>
#include <floe/numeric/gauss_legendre.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace floe::hydro {
namespace {

// Weighted shape functions and positions at the n × n Gauss points of one element
struct ElementRule {
  Eigen::Matrix2Xd position;                        // [m]
  Eigen::Matrix<double, 8, Eigen::Dynamic> weight;  // weight · det J · N_m [m²]
  Eigen::Matrix<double, 8, Eigen::Dynamic> shape;
};

ElementRule element_rule(const Eigen::Matrix<double, 2, 8>& nodes, int order) {
  const auto& gauss = numeric::gauss_legendre(order);
  ElementRule rule{Eigen::Matrix2Xd(2, order * order),
                   Eigen::Matrix<double, 8, Eigen::Dynamic>(8, order * order),
                   Eigen::Matrix<double, 8, Eigen::Dynamic>(8, order * order)};
  for (int i = 0, p = 0; i < order; ++i)
    for (int j = 0; j < order; ++j, ++p) {
      const Eigen::Matrix2d jacobian =
          mesh::q8_shape_gradient(gauss.node[i], gauss.node[j]) * nodes.transpose();
      rule.shape.col(p) = mesh::q8_shape(gauss.node[i], gauss.node[j]);
      rule.weight.col(p) =
          gauss.weight[i] * gauss.weight[j] * jacobian.determinant() * rule.shape.col(p);
      rule.position.col(p) = nodes * rule.shape.col(p);
    }
  return rule;
}

// Gauss points that integrate e^{ikx} N over an element of the largest extent: two more than the
// quadratic needs, and one for every radian across; where the phase hardly changes (a tenth of a
// radian) three err by 1e-8
int order_for_wave(const mesh::Q8Mesh& mesh, double wavenumber) {
  double extent = 0.0;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(e);
    extent = std::max(extent, (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).maxCoeff());
  }
  if (wavenumber * extent < 0.1) return 3;
  return std::clamp(5 + static_cast<int>(std::ceil(wavenumber * extent)), 5, 64);
}

}  // namespace

SparseMatrix surface_mass(const mesh::Q8Mesh& mesh) {
  // Element matrices at 3 × 3 Gauss points, as the plate's own mass
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  entries.reserve(64 * static_cast<std::size_t>(mesh.element_count()));
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const ElementRule rule = element_rule(mesh.element_nodes(e), 3);
    const Eigen::Matrix<double, 8, 8> element = rule.weight * rule.shape.transpose();
    for (int a = 0; a < 8; ++a)
      for (int b = 0; b < 8; ++b)
        entries.emplace_back(mesh.elements()(a, e), mesh.elements()(b, e), element(a, b));
  }
  SparseMatrix mass(mesh.node_count(), mesh.node_count());
  mass.setFromTriplets(entries.begin(), entries.end());
  return mass;
}

MatXcd incident_elevation(const Points2& points, double wavenumber,
                          std::span<const double> heading) {
  MatXcd elevation(points.cols(), static_cast<Index>(heading.size()));
  for (std::size_t b = 0; b < heading.size(); ++b) {
    const Point2 direction(std::cos(heading[b]), std::sin(heading[b]));
    for (Index i = 0; i < points.cols(); ++i)
      elevation(i, static_cast<Index>(b)) =
          std::polar(1.0, wavenumber * direction.dot(points.col(i)));
  }
  return elevation;
}

MatXcd wave_loads(const mesh::Q8Mesh& mesh, double wavenumber, std::span<const double> heading) {
  const int order = order_for_wave(mesh, wavenumber);
  const Index headings = static_cast<Index>(heading.size());
  MatXcd loads = MatXcd::Zero(headings, mesh.node_count());
  constexpr Index kHeadings = 16;  // headings that share one pass over the elements
#pragma omp parallel for schedule(static)
  for (Index first = 0; first < headings; first += kHeadings) {
    const Index count = std::min(kHeadings, headings - first);
    VecXcd value(count);
    for (Index e = 0; e < mesh.element_count(); ++e) {
      const ElementRule rule = element_rule(mesh.element_nodes(e), order);
      for (Index p = 0; p < rule.position.cols(); ++p) {
        for (Index b = 0; b < count; ++b) {
          const double beta = heading[first + b];
          value[b] = std::polar(1.0, wavenumber * (std::cos(beta) * rule.position(0, p) +
                                                   std::sin(beta) * rule.position(1, p)));
        }
        for (int m = 0; m < 8; ++m)
          loads.col(mesh.elements()(m, e)).segment(first, count) += rule.weight(m, p) * value;
      }
    }
  }
  return loads.transpose();
}

std::vector<double> full_circle(int count) {
  std::vector<double> heading(count);
  for (int b = 0; b < count; ++b) heading[b] = 2.0 * std::numbers::pi * b / count;
  return heading;
}

}  // namespace floe::hydro
