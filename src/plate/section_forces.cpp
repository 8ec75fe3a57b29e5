#include <floe/numeric/error.hpp>
#include <floe/plate/section_forces.hpp>

#include <plate/assembly.hpp>
#include <plate/recovery.hpp>

#include <vector>

namespace floe::plate {
namespace {

std::vector<double> element_shares(const IndexLists& at_node) {
  std::vector<double> share(at_node.begin.size() - 1);
  for (std::size_t n = 0; n < share.size(); ++n)
    share[n] = 1.0 / static_cast<double>(at_node.begin[n + 1] - at_node.begin[n]);
  return share;
}

// Adds up, for every node, what its elements say, each with an equal share. `recover(points)`
// gives an element's matrix from 8 · `in` values at its nodes to 8 · `out` values there.
template <typename Recover>
MatXd average_at_nodes(const mesh::Q8Mesh& mesh, const Eigen::Ref<const MatXd>& values, int in,
                       int out, const Recover& recover) {
  const Index columns = values.cols();
  const std::vector<double> share =
      element_shares(elements_of_nodes(mesh.node_count(), mesh.elements()));
  const IndexLists colors = color_elements(mesh.node_count(), mesh.elements());
  MatXd result = MatXd::Zero(out * mesh.node_count(), columns);
  for (std::size_t color = 0; color + 1 < colors.begin.size(); ++color) {
#pragma omp parallel for schedule(static)
    for (Index k = colors.begin[color]; k < colors.begin[color + 1]; ++k) {
      const Index element = colors.value[k];
      MatXd local(8 * in, columns);
      for (int a = 0; a < 8; ++a)
        local.middleRows(in * a, in) = values.middleRows(in * mesh.elements()(a, element), in);
      const MatXd recovered = recover(mesh.element_nodes(element)) * local;
      for (int a = 0; a < 8; ++a) {
        const Index node = mesh.elements()(a, element);
        result.middleRows(out * node, out) += share[node] * recovered.middleRows(out * a, out);
      }
    }
  }
  return result;
}

}  // namespace

MatXd section_forces(const mesh::Q8Mesh& mesh, const PlateProperties& properties,
                     const Eigen::Ref<const MatXd>& displacement) {
  FLOE_EXPECT(displacement.rows() == kUnknownsPerNode * mesh.node_count());
  return average_at_nodes(
      mesh, displacement, kUnknownsPerNode, kSectionForces,
      [&](const ElementNodes& nodes) { return nodal_force_matrix(nodes, properties); });
}

MatXd slopes(const mesh::Q8Mesh& mesh, const Eigen::Ref<const MatXd>& deflection) {
  FLOE_EXPECT(deflection.rows() == mesh.node_count());
  return average_at_nodes(mesh, deflection, 1, 2,
                          [](const ElementNodes& nodes) { return nodal_slope_matrix(nodes); });
}

SparseMatrix section_force_operator(const mesh::Q8Mesh& mesh, const PlateProperties& properties,
                                    std::span<const Index> nodes) {
  const IndexLists at_node = elements_of_nodes(mesh.node_count(), mesh.elements());
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    FLOE_EXPECT(nodes[k] >= 0 && nodes[k] < mesh.node_count());
    const Index first = at_node.begin[nodes[k]], last = at_node.begin[nodes[k] + 1];
    for (Index i = first; i < last; ++i) {
      const Eigen::Matrix<Index, 8, 1> element = mesh.elements().col(at_node.value[i]);
      const NodalForceMatrix matrix =
          nodal_force_matrix(mesh.element_nodes(at_node.value[i]), properties) /
          static_cast<double>(last - first);
      int here = 0;
      while (element[here] != nodes[k]) ++here;
      for (int a = 0; a < 8; ++a)
        for (int c = 0; c < kUnknownsPerNode; ++c)
          for (int r = 0; r < kSectionForces; ++r)
            entries.emplace_back(kSectionForces * k + r, kUnknownsPerNode * element[a] + c,
                                 matrix(kSectionForces * here + r, kUnknownsPerNode * a + c));
    }
  }
  SparseMatrix result(kSectionForces * static_cast<Index>(nodes.size()),
                      kUnknownsPerNode * mesh.node_count());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace floe::plate
