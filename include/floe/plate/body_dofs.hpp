#pragma once

#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/types.hpp>
#include <floe/plate/dry_modes.hpp>

#include <string>
#include <vector>

namespace floe::plate {

/// Which degrees of freedom another program wants of a plate.
enum class DofSet {
  kPlate,         ///< heave, roll, pitch of every body, then the elastic modes
  kSixRigid,      ///< surge, sway, heave, roll, pitch, yaw of every body
  kSixAndElastic  ///< body by body: these six, then its elastic modes
};

/// One degree of freedom.
struct BodyDof {
  int body = 0;      ///< that it moves, from 0; -1: several
  int rigid = 0;     ///< 1 surge … 6 yaw; 0: an elastic mode
  Index mode = -1;   ///< of an elastic one, from 0
  std::string name;  ///< "Heave" or "Elastic_4", 4 the number of the dry mode from 1
};

/// The dry modes told as motions of bodies: heave, roll and pitch by 1 m or 1 rad about the centre
/// of mass (w = 1; w = y - y_c; w = -(x - x_c)), elastic modes as they are, mass-normalised.
/// A body is a piece of the mesh, or all of it where the modes know three rigid motions only.
/// Surge, sway and yaw move nothing in the water under a plate on z = 0: their columns of `motion`
/// are zero, they have inertia only. Where the modes tell no rotary inertia, yaw has that of roll
/// and pitch together.
struct BodyDofs {
  std::vector<std::string> body;  ///< "plate", or "plate_1", "plate_2", …
  Points2 centre;                 ///< of mass and of rotation, on z = 0, one a body [m]
  VecXd mass;                     ///< of each body [kg]
  std::vector<BodyDof> dof;
  MatXd motion;     ///< T, q × d: dof j moved by one unit is ∑ T_ij c_i
  MatXd amplitude;  ///< d × q: dofs of modal amplitudes, T⁻¹ on what the dofs can tell
  MatXd inertia;    ///< d × d [kg, kg m, kg m²; 1 for elastic modes]
  VecXd stiffness;  ///< ω_i² of the elastic dofs, 0 of the rigid ones, d
  Index count() const { return static_cast<Index>(dof.size()); }
};

/// `mesh` is that of the modes. Throws InputError when the first modes do not hold the rigid
/// motions of the bodies to 1e-6.
BodyDofs body_dofs(const mesh::Q8Mesh& mesh, const DryModes& modes, DofSet set);

}  // namespace floe::plate
