#include <floe/mesh/shape_functions.hpp>

namespace floe::mesh {

const Eigen::Matrix<double, 2, 8>& q8_parametric_nodes() {
  static const Eigen::Matrix<double, 2, 8> nodes =
      (Eigen::Matrix<double, 2, 8>() << -1, 1, 1, -1, 0, 1, 0, -1,  //
       -1, -1, 1, 1, -1, 0, 1, 0)
          .finished();
  return nodes;
}

}  // namespace floe::mesh
