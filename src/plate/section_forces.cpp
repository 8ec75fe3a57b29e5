#include "plate/adjacency.hpp"
#include "plate/nodal_average.hpp"
#include "plate/recovery.hpp"

#include <floe/numeric/error.hpp>
#include <floe/plate/section_forces.hpp>

#include <vector>

namespace floe::plate {
MatXd section_forces(const mesh::Q8Mesh& mesh, const PlateRegions& regions,
                     const Eigen::Ref<const MatXd>& displacement) {
  FLOE_EXPECT(displacement.rows() == kUnknownsPerNode * mesh.node_count());
  const NodalAverage average(mesh, all_elements(mesh));
  return average(displacement, kUnknownsPerNode, kSectionForces, [&](Index element) {
    return nodal_force_matrix(mesh.element_nodes(element), regions.of(element));
  });
}

SparseMatrix slope_operator(const mesh::Q8Mesh& mesh, Slope slope) {
  const IndexLists at_node = elements_of_nodes(mesh.node_count(), mesh.elements());
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  entries.reserve(64 * static_cast<std::size_t>(mesh.element_count()));
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const NodalSlopeMatrix gradient = nodal_slope_matrix(mesh.element_nodes(e));
    for (int a = 0; a < 8; ++a) {
      const Index node = mesh.elements()(a, e);
      const auto meeting = static_cast<double>(at_node.begin[node + 1] - at_node.begin[node]);
      for (int b = 0; b < 8; ++b)
        entries.emplace_back(node, mesh.elements()(b, e), gradient(2 * a + slope, b) / meeting);
    }
  }
  SparseMatrix result(mesh.node_count(), mesh.node_count());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

SparseMatrix section_force_operator(const mesh::Q8Mesh& mesh, const PlateRegions& regions,
                                    std::span<const Index> nodes, int region) {
  const IndexLists at_node = elements_of_nodes(mesh.node_count(), mesh.elements());
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    FLOE_EXPECT(nodes[k] >= 0 && nodes[k] < mesh.node_count());
    std::vector<Index> meeting;
    for (Index i = at_node.begin[nodes[k]]; i < at_node.begin[nodes[k] + 1]; ++i)
      if (region < 0 || regions.region(at_node.value[i]) == region)
        meeting.push_back(at_node.value[i]);
    for (const Index e : meeting) {
      const Eigen::Matrix<Index, 8, 1> element = mesh.elements().col(e);
      const NodalForceMatrix matrix = nodal_force_matrix(mesh.element_nodes(e), regions.of(e)) /
                                      static_cast<double>(meeting.size());
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
