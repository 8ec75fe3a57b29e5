#include <floe/mesh/q8_mesh.hpp>
#include <floe/mesh/shape_functions.hpp>
#include <floe/numeric/gauss_legendre.hpp>

#include <Eigen/LU>

#include <utility>

namespace floe::mesh {

Q8Mesh::Q8Mesh(Points2 nodes, Connectivity elements)
    : nodes_(std::move(nodes)), elements_(std::move(elements)) {
  lower_ = nodes_.rowwise().minCoeff();
  upper_ = nodes_.rowwise().maxCoeff();
  size_ = (upper_ - lower_).maxCoeff();
  const auto& rule = numeric::gauss_legendre(3);
  for (Index e = 0; e < element_count(); ++e)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        area_ += rule.weight[i] * rule.weight[j] *
                 (q8_shape_gradient(rule.node[i], rule.node[j]) * element_nodes(e).transpose())
                     .determinant();
  piece_count_ = 1;
  element_piece_.assign(element_count(), 0);
  node_piece_.assign(node_count(), 0);
}

Eigen::Matrix<double, 2, 8> Q8Mesh::element_nodes(Index element) const {
  Eigen::Matrix<double, 2, 8> points;
  for (int a = 0; a < 8; ++a) points.col(a) = nodes_.col(elements_(a, element));
  return points;
}

}  // namespace floe::mesh
