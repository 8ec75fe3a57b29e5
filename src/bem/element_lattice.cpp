#include <floe/bem/element_lattice.hpp>
#include <floe/numeric/error.hpp>

#include <cmath>
#include <utility>

namespace floe::bem {
namespace {

// Offsets of the local nodes from the element's centre, in half edges
constexpr int kOffset[8][2] = {{-1, -1}, {1, -1}, {1, 1},  {-1, 1},
                               {0, -1},  {0, 1},  {-1, 0}, {1, 0}};

// Local number of a node by its offset in half edges; -1 where none has it
int local_number(long dx, long dy) {
  for (int local = 0; local < 8; ++local)
    if (kOffset[local][0] == dx && kOffset[local][1] == dy) return local;
  return -1;
}

}  // namespace

std::optional<ElementLattice> find_element_lattice(const mesh::Q8Mesh& mesh) {
  // Take the first element's box as the cell
  const auto first = mesh.element_nodes(0);
  const Point2 step = first.rowwise().maxCoeff() - first.rowwise().minCoeff();
  const Point2 corner = mesh.lower();
  const double slack =
      1e-9 * step.minCoeff() + 1e-14 * std::max(mesh.lower().norm(), mesh.upper().norm());

  ElementLattice lattice;
  lattice.step_x = step.x();
  lattice.step_y = step.y();
  lattice.nx = std::lround((mesh.upper().x() - corner.x()) / step.x());
  lattice.ny = std::lround((mesh.upper().y() - corner.y()) / step.y());
  lattice.cell.resize(2, mesh.element_count());
  lattice.connectivity.resize(8, mesh.element_count());

  // Find each element's cell, then each of its nodes where the cell has one
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(e);
    const Point2 centre = 0.5 * (nodes.rowwise().maxCoeff() + nodes.rowwise().minCoeff());
    const Index i = std::lround((centre.x() - corner.x()) / step.x() - 0.5);
    const Index j = std::lround((centre.y() - corner.y()) / step.y() - 0.5);
    lattice.cell.col(e) << i, j;
    const Point2 expected(corner.x() + (static_cast<double>(i) + 0.5) * step.x(),
                          corner.y() + (static_cast<double>(j) + 0.5) * step.y());
    for (int a = 0; a < 8; ++a) {
      const Point2 offset = 2.0 * (nodes.col(a) - expected).cwiseQuotient(step);
      const int local = local_number(std::lround(offset.x()), std::lround(offset.y()));
      if (local < 0) return std::nullopt;
      const Point2 ideal =
          expected + 0.5 * step.cwiseProduct(Point2(kOffset[local][0], kOffset[local][1]));
      if ((nodes.col(a) - ideal).cwiseAbs().maxCoeff() > slack) return std::nullopt;
      lattice.connectivity(local, e) = mesh.elements()(a, e);
    }
  }
  return lattice;
}

ElementLattice require_element_lattice(const mesh::Q8Mesh& mesh) {
  auto lattice = find_element_lattice(mesh);
  FLOE_VALIDATE_AS(
      MeshError, lattice.has_value(),
      "method = lattice on this mesh (must have equal rectangular elements, parallel to "
      "the axes, on one lattice)");
  return std::move(*lattice);
}

}  // namespace floe::bem
