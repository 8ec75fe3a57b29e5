#include "bem/plate_grid.hpp"

#include <floe/mesh/point_locator.hpp>
#include <floe/mesh/shape_functions.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace floe::bem {
namespace {

constexpr int kSamplesPerStep = 8;

Point2 size_of(const mesh::Q8Mesh& mesh) { return mesh.upper() - mesh.lower(); }

bool taller_than_wide(const mesh::Q8Mesh& mesh) { return size_of(mesh).y() > size_of(mesh).x(); }

Index cells(double length, double step) {
  return std::max<Index>(1, static_cast<Index>(std::ceil(length / step - 1e-6)));
}

Point2 swap_if(bool swapped, const Point2& p) { return swapped ? Point2(p.y(), p.x()) : p; }

fmm::PaddedGrid make_grid(const Point2& size, double step) {
  return {cells(size.x(), step) + 2 * PlateGrid::kMargin,
          cells(size.y(), step) + 2 * PlateGrid::kMargin};
}

// Cubic Lagrange weights for a place t in [0, 1] between the second and third of four points
std::array<double, 4> cubic_weights(double t) {
  return {-t * (t - 1.0) * (t - 2.0) / 6.0, (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
          -(t + 1.0) * t * (t - 2.0) / 2.0, (t + 1.0) * t * (t - 1.0) / 6.0};
}

// Squared distances along a line: d(i) = min over j of f(j) + (i - j)²
void spread_distances(std::vector<double>& f) {
  std::vector<double> result(f.size());
  for (std::size_t i = 0; i < f.size(); ++i) {
    double least = f[i];
    for (std::size_t gap = 1; double(gap) * double(gap) < least && gap < f.size(); ++gap) {
      const double square = double(gap) * double(gap);
      if (i >= gap) least = std::min(least, f[i - gap] + square);
      if (i + gap < f.size()) least = std::min(least, f[i + gap] + square);
    }
    result[i] = least;
  }
  f.swap(result);
}

}  // namespace

PlateGrid::PlateGrid(const mesh::Q8Mesh& mesh, double step)
    : step_(step),
      swapped_(taller_than_wide(mesh)),
      padded_(make_grid(swap_if(swapped_, size_of(mesh)), step)) {
  const Point2 middle = swap_if(swapped_, 0.5 * (mesh.lower() + mesh.upper()));
  origin_ = middle - 0.5 * step * Point2(double(nx() - 1), double(ny() - 1));
  find_points(mesh);
  find_stencils(mesh);
}

Point2 PlateGrid::to_grid(const Point2& point) const {
  return (swap_if(swapped_, point) - origin_) / step_;
}

// Adds up the plate's area in each cell by samples of the elements; of each cell, the sample that
// is nearest to its middle
std::vector<PlateGrid::Sample> PlateGrid::cover(const mesh::Q8Mesh& mesh,
                                                std::vector<double>& area) const {
  std::vector<Sample> nearest(area.size(), {-1, 0, 0, std::numeric_limits<double>::infinity()});
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const Eigen::Matrix<double, 2, 8> nodes = mesh.element_nodes(e);
    const Point2 extent = nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff();
    const int count = static_cast<int>(std::ceil(extent.maxCoeff() / step_ * kSamplesPerStep));
    const double half = 1.0 / std::max(count, 1);
    for (double eta = half - 1.0; eta < 1.0; eta += 2.0 * half)
      for (double xi = half - 1.0; xi < 1.0; xi += 2.0 * half) {
        const Point2 place = to_grid(nodes * mesh::q8_shape(xi, eta));
        const Eigen::Matrix2d jacobian =
            nodes * mesh::q8_shape_gradient(xi, eta).transpose() / step_;
        const Point2 cell(std::round(place.x()), std::round(place.y()));
        const Index i = std::clamp<Index>(static_cast<Index>(cell.x()), 0, nx() - 1);
        const Index j = std::clamp<Index>(static_cast<Index>(cell.y()), 0, ny() - 1);
        const auto point = static_cast<std::size_t>(i + nx() * j);
        area[point] += 4.0 * half * half * std::abs(jacobian.determinant());
        const double distance = (place - cell).norm();
        if (distance < nearest[point].distance) nearest[point] = {e, xi, eta, distance};
      }
  }
  return nearest;
}

void PlateGrid::find_points(const mesh::Q8Mesh& mesh) {
  std::vector<double> area(static_cast<std::size_t>(point_count()), 0.0);
  const std::vector<Sample> nearest = cover(mesh, area);
  const mesh::PointLocator locator(mesh);
  for (Index point = 0; point < point_count(); ++point)
    if (area[static_cast<std::size_t>(point)] > 0.0) active_.push_back(point);
  const auto count = static_cast<Index>(active_.size());
  share_.resize(count);
  source_node_.resize(8, count);
  source_weight_.resize(8, count);
#pragma omp parallel for schedule(static)
  for (Index a = 0; a < count; ++a) {
    const Index point = active_[static_cast<std::size_t>(a)];
    const Index row = point / nx();
    const Point2 place = origin_ + step_ * Point2(double(point - row * nx()), double(row));
    const Sample& sample = nearest[static_cast<std::size_t>(point)];
    mesh::ElementPoint at{sample.element, sample.xi, sample.eta};
    if (const auto found = locator.locate(swap_if(swapped_, place))) at = *found;
    share_[a] = std::min(1.0, area[static_cast<std::size_t>(point)]);
    source_node_.col(a) = mesh.elements().col(at.element);
    source_weight_.col(a) = mesh::q8_shape(at.xi, at.eta);
  }
}

void PlateGrid::find_stencils(const mesh::Q8Mesh& mesh) {
  stencil_.resize(static_cast<std::size_t>(mesh.node_count()));
  for (Index node = 0; node < mesh.node_count(); ++node) {
    const Point2 place = to_grid(mesh.nodes().col(node));
    const Index i = std::clamp<Index>(static_cast<Index>(std::floor(place.x())), 1, nx() - 3);
    const Index j = std::clamp<Index>(static_cast<Index>(std::floor(place.y())), 1, ny() - 3);
    stencil_[static_cast<std::size_t>(node)] = {(i - 1) + nx() * (j - 1),
                                                cubic_weights(place.x() - double(i)),
                                                cubic_weights(place.y() - double(j))};
  }
}

MatXcd PlateGrid::restrict_to_points(const Eigen::Ref<const MatXcd>& nodal) const {
  const auto count = static_cast<Index>(active_.size());
  MatXcd value(count, nodal.cols());
#pragma omp parallel for schedule(static)
  for (Index column = 0; column < nodal.cols(); ++column)
    for (Index a = 0; a < count; ++a) {
      Complex sum = 0.0;
      for (int l = 0; l < 8; ++l) sum += source_weight_(l, a) * nodal(source_node_(l, a), column);
      value(a, column) = sum;
    }
  return value;
}

void PlateGrid::interpolate_add(const Complex* field, Complex* nodal) const {
  const auto count = static_cast<Index>(stencil_.size());
#pragma omp parallel for schedule(static)
  for (Index node = 0; node < count; ++node) {
    const Stencil& stencil = stencil_[static_cast<std::size_t>(node)];
    Complex sum = 0.0;
    for (std::size_t j = 0; j < 4; ++j) {
      const Complex* row = field + stencil.first + static_cast<Index>(j) * nx();
      Complex part = 0.0;
      for (std::size_t i = 0; i < 4; ++i) part += stencil.x[i] * row[i];
      sum += stencil.y[j] * part;
    }
    nodal[node] += sum;
  }
}

double PlateGrid::width() const {
  // Squared distance of each point to the nearest cell that is mostly uncovered, in steps
  const double far = double(nx() * nx() + ny() * ny());
  MatXd square = MatXd::Zero(nx(), ny());
  for (std::size_t a = 0; a < active_.size(); ++a)
    if (share_[static_cast<Index>(a)] >= 0.5) square(active_[a] % nx(), active_[a] / nx()) = far;
  std::vector<double> line(static_cast<std::size_t>(nx()));
  for (Index j = 0; j < ny(); ++j) {
    for (Index i = 0; i < nx(); ++i) line[static_cast<std::size_t>(i)] = square(i, j);
    spread_distances(line);
    for (Index i = 0; i < nx(); ++i) square(i, j) = line[static_cast<std::size_t>(i)];
  }
  line.resize(static_cast<std::size_t>(ny()));
  double largest = 1.0;
  for (Index i = 0; i < nx(); ++i) {
    for (Index j = 0; j < ny(); ++j) line[static_cast<std::size_t>(j)] = square(i, j);
    spread_distances(line);
    largest = std::max(largest, *std::max_element(line.begin(), line.end()));
  }
  // The edge lies half a step before the first uncovered point
  return step_ * std::max(1.0, 2.0 * std::sqrt(largest) - 1.0);
}

}  // namespace floe::bem
