#pragma once

#include "plate/sparse_products.hpp"

#include <floe/plate/dry_modes.hpp>
#include <floe/plate/mindlin.hpp>

#include <optional>
#include <vector>

namespace floe::plate {

/// One connected piece of the mesh, with nodes and elements numbered by themselves.
struct Piece {
  std::vector<Index> node;     ///< of the mesh, rising
  std::vector<Index> element;  ///< likewise
  Points2 nodes;               ///< [m]
  mesh::Connectivity elements;
};
std::vector<Piece> split_pieces(const mesh::Q8Mesh& mesh);

/// Area and centre of area.
struct AreaMoments {
  double area = 0.0;
  Point2 centroid = Point2::Zero();
};
AreaMoments area_moments(const Piece& piece);

/// Area of each region within these elements [m²].
std::vector<double> region_areas(const Points2& nodes, const mesh::Connectivity& elements,
                                 const PlateRegions& regions);

/// Heave, roll and pitch about `centre`, each scaled to cᵀMc = 1.
MatXd rigid_modes(const Points2& nodes, const Point2& centre, const NodeMass& mass);

/// The lowest modes of one piece.
struct PieceModes {
  MatXd rigid;                   ///< 3n × 3
  MatXd modal_mass;              ///< of the rigid ones, 3 × 3
  VecXd eigenvalue;              ///< ω² of the elastic ones [rad²/s²], rising
  MatXd elastic;                 ///< 3n × count, M-orthonormal, and M-orthogonal to the rigid ones
  double rotary_inertia = 0.0;   ///< θᵀMθ of θx = 1 or θy = 1 alone, the mean [kg m²]
  double bent_eigenvalue = 0.0;  ///< ω² of the softest constant curvature: the shift s
  double orthonormality_error = 0.0;  ///< as in DryModes
  double rigid_force_error = 0.0;
  DryModeReport report;
};

/// The rigid and the lowest `options.count` elastic modes; all elastic ones where the piece has no
/// more. Throws as dry_modes.
PieceModes piece_modes(const Piece& piece, const PlateRegions& regions,
                       const DryModeOptions& options);

/// The same of K and M of the piece; `curvature_energy` is twice the strain energy of the constant
/// curvatures of w = (a x² + 2b xy + c y²)/2, from K where it is not known otherwise.
PieceModes piece_modes(const Piece& piece, const PlateMatrices& plate,
                       const std::optional<Eigen::Matrix3d>& curvature_energy,
                       const DryModeOptions& options);

/// θᵀMθ of θx = 1 alone and of θy = 1 alone at these nodes, the mean: ∫ρt³/12 dS [kg m²].
double rotary_inertia(const SparseMatrix& mass, const std::vector<Index>& nodes);

/// The sign that makes the largest |w| positive; of nearly equal ones that of the first node
/// counts.
double shape_sign(const Eigen::Ref<const VecXd>& shape);

/// Puts the modes of the pieces together: all rigid ones, and the lowest elastic ones.
DryModes join_modes(const mesh::Q8Mesh& mesh, const std::vector<Piece>& pieces,
                    const std::vector<PieceModes>& modes, Index elastic_count);

/// The number of modes that a mesh can have. Throws InputError when `count` is none such.
void check_mode_count(const mesh::Q8Mesh& mesh, int count);

}  // namespace floe::plate
