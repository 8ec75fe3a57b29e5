#include "plate/element.hpp"

#include <Eigen/LU>

#include <cmath>

namespace floe::plate {
namespace {

// The tying points lie at plus and minus this along an edge
const double kTyingPoint = 1.0 / std::sqrt(3.0);

}  // namespace

AssumedShear::AssumedShear(const ElementNodes& nodes)
    : nodes_(nodes), along_xi_(tie(0)), along_eta_(tie(1)) {
  // Of the differences inside the element, take out what departs from those on the edges, and what
  // both directions have of it in common.
  // NOTE: the deflection of a constant curvature may need (1 - ξ²)(1 - η²), which the eight
  // functions lack where the sides are not parallel. Its share in the differences is the same in
  // both directions, and in the means zero. So nothing of it is left, and the plate does not lock;
  // with plain values at 2 × 2 Gauss points it does, on such elements.
  std::array<Row, 3>& xi = along_xi_.difference;
  std::array<Row, 3>& eta = along_eta_.difference;
  const Row xi_edges = 0.5 * (xi[0] + xi[2]), eta_edges = 0.5 * (eta[0] + eta[2]);
  const Row own = 0.5 * ((xi[1] - xi_edges) - (eta[1] - eta_edges));
  xi[1] = xi_edges + own;
  eta[1] = eta_edges - own;
}

AssumedShear::Tied AssumedShear::tie(int direction) const {
  const auto strain = [&](double along, double across) {
    const double xi = direction == 0 ? along : across, eta = direction == 0 ? across : along;
    const mesh::Shape8 shape = mesh::q8_shape(xi, eta);
    const Eigen::Matrix<double, 1, 8> derivative = mesh::q8_shape_gradient(xi, eta).row(direction);
    const Eigen::RowVector2d tangent = derivative * nodes_.transpose();
    Row row;
    for (int a = 0; a < 8; ++a)
      row.segment<3>(3 * a) << derivative[a], -tangent[1] * shape[a], tangent[0] * shape[a];
    return row;
  };
  Tied tied;
  for (int t = 0; t < 3; ++t) {
    const Row plus = strain(kTyingPoint, t - 1), minus = strain(-kTyingPoint, t - 1);
    tied.mean[t] = 0.5 * (plus + minus);
    tied.difference[t] = 0.5 * (plus - minus);
  }
  return tied;
}

ShearMatrix AssumedShear::at(double xi, double eta) const {
  const auto interpolate = [](const Tied& tied, double along, double across) {
    const std::array<double, 3> weight{0.5 * across * (across - 1.0), 1.0 - across * across,
                                       0.5 * across * (across + 1.0)};
    Row row = Row::Zero();
    for (int t = 0; t < 3; ++t)
      row += weight[t] * tied.mean[t] + (weight[t] * along / kTyingPoint) * tied.difference[t];
    return row;
  };
  ShearMatrix covariant;
  covariant.row(0) = interpolate(along_xi_, xi, eta);
  covariant.row(1) = interpolate(along_eta_, eta, xi);
  const Eigen::Matrix2d jacobian = mesh::q8_shape_gradient(xi, eta) * nodes_.transpose();
  return jacobian.inverse() * covariant;
}

}  // namespace floe::plate
