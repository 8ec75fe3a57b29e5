#pragma once

#include "plate/adjacency.hpp"

#include <floe/mesh/q8_mesh.hpp>

#include <vector>

namespace floe::plate {

/// Averages at the nodes of a mesh over those of given elements that meet there, in parallel and
/// with the same bits for any number of threads. Keeps a view of the mesh.
class NodalAverage final {
 public:
  NodalAverage(const mesh::Q8Mesh& mesh, const std::vector<Index>& elements);

  /// `recover(element)` gives the matrix from 8 · `in` values at the element's nodes to 8 · `out`
  /// there. `values` has `in` rows a node, the result `out`; zero at nodes without an element.
  template <typename Recover>
  MatXd operator()(const Eigen::Ref<const MatXd>& values, int in, int out,
                   const Recover& recover) const {
    MatXd result = MatXd::Zero(out * mesh_.node_count(), values.cols());
    for (std::size_t color = 0; color + 1 < colors_.begin.size(); ++color) {
#pragma omp parallel for schedule(static)
      for (Index k = colors_.begin[color]; k < colors_.begin[color + 1]; ++k) {
        const Index element = elements_[colors_.value[k]];
        const MatXd recovered = recover(element) * gather(values, in, element);
        for (int a = 0; a < 8; ++a) {
          const Index node = mesh_.elements()(a, element);
          result.middleRows(out * node, out) += share_[node] * recovered.middleRows(out * a, out);
        }
      }
    }
    return result;
  }

  /// The values of the eight nodes of an element, one below the other.
  MatXd gather(const Eigen::Ref<const MatXd>& values, int rows, Index element) const;

 private:
  const mesh::Q8Mesh& mesh_;  // view
  std::vector<Index> elements_;
  IndexLists colors_;
  std::vector<double> share_;
};

std::vector<Index> all_elements(const mesh::Q8Mesh& mesh);

}  // namespace floe::plate
