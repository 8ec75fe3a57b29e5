#pragma once

#include "plate/sparse_products.hpp"

#include <floe/plate/dry_modes.hpp>
#include <floe/plate/mindlin.hpp>

#include <vector>

namespace floe::plate {

/// One connected piece of the mesh, with nodes and elements numbered by themselves.
struct Piece {
  std::vector<Index> node;  ///< of the mesh, rising
  Points2 nodes;            ///< [m]
  mesh::Connectivity elements;
};
std::vector<Piece> split_pieces(const mesh::Q8Mesh& mesh);

/// Area and centre of area.
struct AreaMoments {
  double area = 0.0;
  Point2 centroid = Point2::Zero();
};
AreaMoments area_moments(const Piece& piece);

/// Heave, roll and pitch about `centre`, each scaled to cᵀMc = 1.
MatXd rigid_modes(const Points2& nodes, const Point2& centre, const NodeMass& mass);

/// The lowest modes of one piece.
struct PieceModes {
  MatXd rigid;       ///< 3n × 3
  MatXd modal_mass;  ///< of the rigid ones, 3 × 3
  VecXd eigenvalue;  ///< ω² of the elastic ones [rad²/s²], rising
  MatXd elastic;     ///< 3n × count, M-orthonormal, and M-orthogonal to the rigid ones
  double orthonormality_error = 0.0;  ///< as in DryModes
  double rigid_force_error = 0.0;
  DryModeReport report;
};

/// The rigid and the lowest `options.count` elastic modes; all elastic ones where the piece has no
/// more. Throws as dry_modes.
PieceModes piece_modes(const Piece& piece, const PlateProperties& properties,
                       const DryModeOptions& options);

}  // namespace floe::plate
