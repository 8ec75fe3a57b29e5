#include "bem/worst_column.hpp"

#include <floe/bem/residual_between_nodes.hpp>
#include <floe/mesh/shape_functions.hpp>
#include <floe/numeric/error.hpp>

#include <algorithm>
#include <numbers>

namespace floe::bem {
namespace {

// Values of nodal columns in the middle of an element
Eigen::RowVectorXcd in_middle(const mesh::Q8Mesh& mesh, Index element,
                              const Eigen::Ref<const MatXcd>& nodal) {
  const mesh::Shape8 shape = mesh::q8_shape(0.0, 0.0);
  Eigen::RowVectorXcd value = Eigen::RowVectorXcd::Zero(nodal.cols());
  for (int a = 0; a < 8; ++a) value += shape[a] * nodal.row(mesh.elements()(a, element));
  return value;
}

}  // namespace

double residual_between_nodes(const ElementIntegrals& integrals, const green::GreenTable& green,
                              const Eigen::Ref<const MatXcd>& x, const Eigen::Ref<const MatXcd>& b,
                              Index elements) {
  const mesh::Q8Mesh& mesh = integrals.mesh();
  FLOE_EXPECT(x.rows() == mesh.node_count() && b.rows() == x.rows() && b.cols() == x.cols());
  FLOE_EXPECT(elements > 0);
  const double kappa = green.exact().nu() / (4.0 * std::numbers::pi);
  const Index count = std::min(elements, mesh.element_count());
  MatXcd residual(count, x.cols());
#pragma omp parallel for schedule(dynamic, 1)
  for (Index i = 0; i < count; ++i) {
    const Index element = (2 * i + 1) * mesh.element_count() / (2 * count);
    VecXcd row(mesh.node_count());
    integrals.point_row(mesh.element_nodes(element) * mesh::q8_shape(0.0, 0.0), green, row);
    residual.row(i) =
        in_middle(mesh, element, b) - in_middle(mesh, element, x) - kappa * (row.transpose() * x);
  }
  return worst_column(residual, b);
}

}  // namespace floe::bem
