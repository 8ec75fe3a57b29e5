#include "plate/nodal_average.hpp"

#include <numeric>

namespace floe::plate {

NodalAverage::NodalAverage(const mesh::Q8Mesh& mesh, const std::vector<Index>& elements)
    : mesh_(mesh), elements_(elements), share_(mesh.node_count(), 0.0) {
  const mesh::Connectivity chosen = mesh.elements()(Eigen::all, elements_);
  colors_ = color_elements(mesh.node_count(), chosen);
  for (const Index node : chosen.reshaped()) share_[node] += 1.0;
  for (double& share : share_)
    if (share > 0.0) share = 1.0 / share;
}

MatXd NodalAverage::gather(const Eigen::Ref<const MatXd>& values, int rows, Index element) const {
  MatXd gathered(8 * rows, values.cols());
  for (int a = 0; a < 8; ++a)
    gathered.middleRows(rows * a, rows) =
        values.middleRows(rows * mesh_.elements()(a, element), rows);
  return gathered;
}

std::vector<Index> all_elements(const mesh::Q8Mesh& mesh) {
  std::vector<Index> elements(mesh.element_count());
  std::iota(elements.begin(), elements.end(), Index{0});
  return elements;
}

}  // namespace floe::plate
