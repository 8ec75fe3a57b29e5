#pragma once

#include <floe/mesh/q8_mesh.hpp>

#include <Eigen/SparseCore>

#include <vector>

namespace floe::bem {

/// How the pressure on far elements is replaced by point charges: the matrix S of (F.2).
enum class SourcePoints {
  /// The nodes themselves with the charges q = ∫ N p dS: G is interpolated by the shape functions
  /// over each element (F.21). As many points as nodes.
  kNodes,
  /// n × n Gauss points an element.
  kGauss3,
  kGauss4,
  kGauss5,
  kGauss6,
};

/// Source points of a mesh and the charges there. Immutable, frequency-independent.
class SourceRule {
 public:
  SourceRule(const mesh::Q8Mesh& mesh, SourcePoints kind);

  const Points2& points() const { return points_; }  ///< [m]
  int points_per_element() const { return per_element_; }
  bool at_nodes() const { return kind_ == SourcePoints::kNodes; }

  /// Number of point p of an element, 0 ≤ p < points_per_element().
  Index point(Index element, int p) const {
    return at_nodes() ? elements_(p, element) : per_element_ * element + p;
  }

  /// sum[m] = Σ_p value[p] · charge at point p of the element per unit of its local nodal value m
  /// [m²]: its row of K S for a kernel with these values. Changes the values.
  void collect(Index element, Complex* value, Complex* sum) const;

  /// charges (points × columns) = S times nodal values (nodes × columns).
  void spread(const Eigen::Ref<const MatXcd>& values, Eigen::Ref<MatXcd> charges) const;

  double memory() const;  ///< [byte]

 private:
  void place_at_nodes(const mesh::Q8Mesh& mesh);
  void place_at_gauss_points(const mesh::Q8Mesh& mesh, int order);

  SourcePoints kind_;
  mesh::Connectivity elements_;
  int per_element_ = 8;
  Points2 points_;
  std::vector<double> area_;   // of each Gauss point [m²]
  std::vector<double> shape_;  // 8 functions at each Gauss point of an element
  Eigen::Matrix<double, 64, Eigen::Dynamic> element_mass_;  // of nodes: ∫ N_m N_p dS of an element
  Eigen::SparseMatrix<double, Eigen::RowMajor, int> mass_;  // of nodes: S
};

}  // namespace floe::bem
