#pragma once

#include <floe/mesh/shape_functions.hpp>
#include <floe/plate/mindlin.hpp>

#include <array>

/// The Q8 Mindlin element. Unknowns of its node a: 3a (w), 3a + 1 (θx), 3a + 2 (θy).
namespace floe::plate {

inline constexpr int kElementUnknowns = 8 * kUnknownsPerNode;
using ElementNodes = Eigen::Matrix<double, 2, 8>;
using ElementMatrix = Eigen::Matrix<double, kElementUnknowns, kElementUnknowns>;

/// Shape functions with their derivatives in x and y at one point of an element.
struct ElementPointValues {
  mesh::Shape8 shape;
  mesh::ShapeGradient8 gradient;  ///< rows ∂/∂x, ∂/∂y [1/m]
  double jacobian;                ///< determinant, dx dy = jacobian dξ dη [m²]
};
ElementPointValues evaluate_element(const ElementNodes& nodes, double xi, double eta);

/// Rows κx, κy, κxy (P.2) at a point, from the element's unknowns.
using CurvatureMatrix = Eigen::Matrix<double, 3, kElementUnknowns>;
CurvatureMatrix curvature_matrix(const ElementPointValues& point);

/// Rows γx, γy (P.2) of the element's assumed shear strains, from its unknowns. The covariant
/// strains γξ = w,ξ + x,ξ θy - y,ξ θx and γη are evaluated at twelve points and interpolated (P.6):
/// γξ at ξ = ±1/√3 on the edges η = ±1 and on η = 0. Of the values on η = 0 count their mean and of
/// the difference only what it does not share with that of γη.
/// For deflections alone this is the gradient, exactly. It differs for rotations, so that none of
/// constant curvature meets a shear strain in an element with straight sides, whatever its shape.
using ShearMatrix = Eigen::Matrix<double, 2, kElementUnknowns>;
class AssumedShear final {
 public:
  explicit AssumedShear(const ElementNodes& nodes);
  ShearMatrix at(double xi, double eta) const;

 private:
  using Row = Eigen::Matrix<double, 1, kElementUnknowns>;
  // One direction, here ξ: the mean of the values at ξ = ±1/√3 and half their difference, at
  // η = -1, 0 and 1
  struct Tied {
    std::array<Row, 3> mean;
    std::array<Row, 3> difference;
  };
  Tied tie(int direction) const;

  ElementNodes nodes_;
  Tied along_xi_, along_eta_;
};

/// Bending moments from curvatures, M = D(…)κ (P.3).
Eigen::Matrix3d bending_law(const PlateProperties& properties);

/// Shear forces from shear strains, Q = (shear correction) G t γ (P.3) [N/m].
double shear_law(const PlateProperties& properties);

ElementMatrix element_stiffness(const ElementNodes& nodes, const PlateProperties& properties);

/// ∫ N_a N_b dS [m²].
Eigen::Matrix<double, 8, 8> element_shape_products(const ElementNodes& nodes);

}  // namespace floe::plate
