#include <floe/hydro/surface_integrals.hpp>
#include <floe/mesh/shape_functions.hpp>
#include <floe/numeric/error.hpp>
#include <floe/numeric/gauss_legendre.hpp>
#include <floe/numeric/unit_phases.hpp>

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

// Gauss points that integrate e^{ikx} N over an element of the largest extent to 1e-9 of its area.
// n points are exact to degree 2n - 1, three of which N takes (more on curved sides, where it makes
// the wave's phase a polynomial too): what is left of e^{iκξ}, κ = k extent / 2, is below the
// first Chebyshev term beyond, 2 (κ/2)^m / m! with m = 2n - 3
int order_for_wave(const mesh::Q8Mesh& mesh, double wavenumber) {
  constexpr double kError = 1e-9;
  double extent = 0.0;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(e);
    extent = std::max(extent, (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).maxCoeff());
  }
  const double half = 0.25 * wavenumber * extent;
  for (int order = 3; order < 64; ++order) {
    const int m = 2 * order - 3;
    if (2.0 * std::exp(m * std::log(half) - std::lgamma(m + 1.0)) <= kError) return order;
  }
  return 64;
}

// Directions (cos β, sin β) of a few headings
Eigen::Matrix2Xd directions(std::span<const double> heading) {
  Eigen::Matrix2Xd direction(2, static_cast<Index>(heading.size()));
  for (std::size_t b = 0; b < heading.size(); ++b)
    direction.col(static_cast<Index>(b)) << std::cos(heading[b]), std::sin(heading[b]);
  return direction;
}

// ∫ N cos k·x and ∫ N sin k·x of a block of headings: 2 count × N
MatXd wave_load_block(const mesh::Q8Mesh& mesh, double wavenumber, int order,
                      const Eigen::Matrix2Xd& direction) {
  const Index count = direction.cols(), points = order * order;
  MatXd loads = MatXd::Zero(2 * count, mesh.node_count());
  MatXd angle(points, count), wave(points, 2 * count);
  Eigen::Matrix<double, 8, Eigen::Dynamic> element(8, 2 * count);
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const ElementRule rule = element_rule(mesh.element_nodes(e), order);
    angle.noalias() = wavenumber * (rule.position.transpose() * direction);
    numeric::unit_phases(angle.data(), angle.size(), wave.data(), wave.data() + angle.size());
    element.noalias() = rule.weight * wave;
    for (int m = 0; m < 8; ++m) loads.col(mesh.elements()(m, e)) += element.row(m).transpose();
  }
  return loads;
}

constexpr Index kHeadingBlock = 16;  // share one pass over the elements

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
  const Eigen::Matrix2Xd direction = directions(heading);
  MatXcd loads(mesh.node_count(), direction.cols());
#pragma omp parallel for schedule(static)
  for (Index first = 0; first < direction.cols(); first += kHeadingBlock) {
    const Index count = std::min(kHeadingBlock, direction.cols() - first);
    const MatXd block =
        wave_load_block(mesh, wavenumber, order, direction.middleCols(first, count));
    for (Index b = 0; b < count; ++b) {
      loads.col(first + b).real() = block.row(b).transpose();
      loads.col(first + b).imag() = block.row(count + b).transpose();
    }
  }
  return loads;
}

MatXcd full_circle_transform(const mesh::Q8Mesh& mesh, double wavenumber, int count,
                             const Eigen::Ref<const MatXcd>& field) {
  FLOE_EXPECT(count > 0 && count % 2 == 0);
  const int order = order_for_wave(mesh, wavenumber);
  const std::vector<double> heading = full_circle(count);
  const Index half = count / 2, columns = field.cols();
  const Eigen::Matrix2Xd direction = directions(std::span(heading).first(half));
  const MatXd parts =
      (MatXd(2 * columns, field.rows()) << field.real().transpose(), field.imag().transpose())
          .finished();
  MatXcd transform(columns, count);
#pragma omp parallel for schedule(dynamic)
  for (Index first = 0; first < half; first += kHeadingBlock) {
    const Index block = std::min(kHeadingBlock, half - first);
    const MatXd loads =
        wave_load_block(mesh, wavenumber, order, direction.middleCols(first, block));
    const MatXd product = parts * loads.transpose();
    MatXcd even(columns, block), odd(columns, block);
    even.real() = product.topLeftCorner(columns, block);
    even.imag() = product.bottomLeftCorner(columns, block);
    odd.real() = -product.bottomRightCorner(columns, block);
    odd.imag() = product.topRightCorner(columns, block);
    transform.middleCols(first, block) = even + odd;
    transform.middleCols(half + first, block) = even - odd;
  }
  return transform;
}

std::vector<double> full_circle(int count) {
  std::vector<double> heading(count);
  for (int b = 0; b < count; ++b) heading[b] = 2.0 * std::numbers::pi * b / count;
  return heading;
}

}  // namespace floe::hydro
