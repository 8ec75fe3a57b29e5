#pragma once

#include "tiny_meshes.hpp"

#include <floe/mesh/rectangle.hpp>
#include <floe/plate/mindlin.hpp>

#include <omp.h>

#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

/// Plates that the tests of this folder share.
namespace floe::test {

/// Table 1 of the paper.
inline plate::PlateProperties table1_properties() {
  return {.thickness = 2.0, .youngs_modulus = 1.19e10, .poisson_ratio = 0.13, .density = 256.25};
}
inline mesh::Q8Mesh table1_mesh(int nx, int ny) {
  return rectangle_arrays(nx, ny, 300.0, 60.0).build();
}

/// A plate whose bending rigidity and mass per area are 1.
inline plate::PlateProperties unit_plate(double thickness, double poisson_ratio) {
  const double t = thickness;
  return {.thickness = t,
          .youngs_modulus = 12.0 * (1.0 - poisson_ratio * poisson_ratio) / (t * t * t),
          .poisson_ratio = poisson_ratio,
          .density = 1.0 / t};
}

/// Sides made straight: mid-side nodes moved to the middle between the corners.
inline MeshArrays straightened(MeshArrays arrays) {
  for (Index e = 0; e < arrays.elements.cols(); ++e)
    for (int side = 0; side < 4; ++side)
      arrays.nodes.col(arrays.elements(4 + side, e)) =
          0.5 * (arrays.nodes.col(arrays.elements(side, e)) +
                 arrays.nodes.col(arrays.elements((side + 1) % 4, e)));
  return arrays;
}

/// A rectangle, its nodes inside moved by up to `shift` [m] and its sides bent.
inline MeshArrays bent_rectangle(int nx, int ny, double length, double width, double shift) {
  return mapped(rectangle_arrays(nx, ny, length, width), [=](const Point2& p) {
    const double x = 2.0 * p.x() / length, y = 2.0 * p.y() / width;
    return Point2(p.x() + shift * (1.0 - x * x) * std::sin(9.0 * x + 7.0 * y + 0.3),
                  p.y() + shift * (1.0 - y * y) * std::cos(8.0 * x + 5.0 * y));
  });
}

/// The same with straight sides.
inline MeshArrays distorted_rectangle(int nx, int ny, double length, double width, double shift) {
  return straightened(bent_rectangle(nx, ny, length, width, shift));
}

/// An L of two arms [m], `across` elements wide.
inline MeshArrays l_shape(double length, double arm, int across) {
  const int count = static_cast<int>(std::lround(across * length / arm));
  const MeshArrays square = rectangle_arrays(count, count, length, length);
  std::vector<Index> kept;
  for (Index e = 0; e < square.elements.cols(); ++e) {
    const Point2 corner = square.nodes.col(square.elements(0, e));
    if (corner.x() < arm - 0.5 * length - 1e-9 || corner.y() < arm - 0.5 * length - 1e-9)
      kept.push_back(e);
  }
  MeshArrays shape{Points2(2, square.nodes.cols()), square.elements(Eigen::all, kept)};
  std::vector<Index> number(square.nodes.cols(), -1);
  Index nodes = 0;
  for (Index& n : shape.elements.reshaped()) {
    if (number[n] < 0) {
      number[n] = nodes;
      shape.nodes.col(nodes++) = square.nodes.col(n);
    }
    n = number[n];
  }
  shape.nodes.conservativeResize(2, nodes);
  return shape;
}

/// One element with nodes moved from the square of side 2 by up to `shift`, at random.
inline MeshArrays random_element(double shift, unsigned seed) {
  std::mt19937 generator(seed);
  const auto draw = [&] { return shift * (static_cast<double>(generator()) * 0x1p-31 - 1.0); };
  return mapped(rectangle_arrays(1, 1, 2.0, 2.0), [&](const Point2& p) {
    const double dx = draw(), dy = draw();
    return Point2(p.x() + dx, p.y() + dy);
  });
}

/// w, θx, θy at the nodes, one below the other, from a function of x and y.
template <typename Field>
VecXd nodal_values(const mesh::Q8Mesh& mesh, const Field& field) {
  VecXd values(3 * mesh.node_count());
  for (Index n = 0; n < mesh.node_count(); ++n)
    values.segment<3>(3 * n) = field(mesh.nodes()(0, n), mesh.nodes()(1, n));
  return values;
}

/// Deflection of constant curvature, (a x² + 2b xy + c y²)/2, with the rotations of no shear
/// strain.
inline VecXd constant_curvature(const mesh::Q8Mesh& mesh, double a, double b, double c) {
  return nodal_values(mesh, [=](double x, double y) {
    return Eigen::Vector3d(0.5 * (a * x * x + 2.0 * b * x * y + c * y * y), b * x + c * y,
                           -(a * x + b * y));
  });
}

/// Which nodes lie on the edge of the plate.
inline std::vector<bool> edge_nodes(const mesh::Q8Mesh& mesh) {
  std::vector<int> elements_at(mesh.node_count(), 0);
  for (const Index n : mesh.elements().reshaped()) ++elements_at[n];
  std::vector<bool> on_edge(mesh.node_count(), false);
  for (Index e = 0; e < mesh.element_count(); ++e)
    for (int side = 0; side < 4; ++side)
      if (elements_at[mesh.elements()(4 + side, e)] == 1)
        for (const int a : {side, 4 + side, (side + 1) % 4}) on_edge[mesh.elements()(a, e)] = true;
  return on_edge;
}

/// Sets the number of OpenMP threads while it lives.
class ThreadCount {
 public:
  explicit ThreadCount(int count) : before_(omp_get_max_threads()) { omp_set_num_threads(count); }
  ~ThreadCount() { omp_set_num_threads(before_); }
  ThreadCount(const ThreadCount&) = delete;
  ThreadCount& operator=(const ThreadCount&) = delete;

 private:
  int before_;
};
inline constexpr std::array<int, 4> kThreadCounts{1, 2, 3, 7};

inline bool same_bits(const SparseMatrix& a, const SparseMatrix& b) {
  return a.nonZeros() == b.nonZeros() &&
         std::equal(a.valuePtr(), a.valuePtr() + a.nonZeros(), b.valuePtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

}  // namespace floe::test
