#pragma once

#include <floe/fmm/padded_grid.hpp>
#include <floe/mesh/q8_mesh.hpp>

#include <array>
#include <vector>

namespace floe::bem {

/// A square grid over the plates, whatever their mesh, and the ways between nodes and grid points.
/// Points are centres of cells; the first and last kMargin rows and columns lie outside the
/// bounding box, so that interpolation never ends. Its x-axis is the longer side of the box.
class PlateGrid {
 public:
  static constexpr Index kMargin = 2;

  /// `step` [m] is the edge of a cell; the box is in the middle.
  PlateGrid(const mesh::Q8Mesh& mesh, double step);

  double step() const { return step_; }
  const fmm::PaddedGrid& padded() const { return padded_; }
  Index nx() const { return padded_.nx(); }
  Index ny() const { return padded_.ny(); }
  Index point_count() const { return nx() * ny(); }

  /// Grid points whose cells hold some of the plate, and how much of each cell it covers (0 … 1).
  const std::vector<Index>& active() const { return active_; }
  const VecXd& share() const { return share_; }

  /// Values at the active points from values at nodes by the Q8 functions; where the middle of a
  /// cell is not covered, at the nearest place in the cell that is.
  MatXcd restrict_to_points(const Eigen::Ref<const MatXcd>& nodal) const;

  /// nodal += values of the bicubic interpolation of one field on all grid points.
  void interpolate_add(const Complex* field, Complex* nodal) const;

  /// Twice the largest distance of a point of the plate to its edge [m]: the width of a rectangle
  /// or of the arms of an L, the wall of a ring.
  double width() const;

 private:
  struct Sample {
    Index element;
    double xi, eta;
    double distance;  // to the middle of the cell
  };
  struct Stencil {
    Index first;  // lower left of 4 × 4 points
    std::array<double, 4> x, y;
  };

  Point2 to_grid(const Point2& point) const;  // in steps, from the first point
  std::vector<Sample> cover(const mesh::Q8Mesh& mesh, std::vector<double>& area) const;
  void find_points(const mesh::Q8Mesh& mesh);
  void find_stencils(const mesh::Q8Mesh& mesh);

  double step_;
  bool swapped_;  // x of the grid is y of the mesh
  Point2 origin_;
  fmm::PaddedGrid padded_;
  std::vector<Index> active_;
  VecXd share_;
  Eigen::Matrix<Index, 8, Eigen::Dynamic> source_node_;  // of each active point
  Eigen::Matrix<double, 8, Eigen::Dynamic> source_weight_;
  std::vector<Stencil> stencil_;  // of each node
};

}  // namespace floe::bem
