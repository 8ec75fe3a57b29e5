#pragma once

#include <floe/analysis.hpp>
#include <floe/mesh/mesh_quality.hpp>

#include <limits>
#include <string>
#include <vector>

/// What can be known about a case before anything is solved.
namespace floe {

/// How well the mesh follows the waves of one frequency. Nodes lie half an element edge apart; the
/// mesh's longest edge counts.
struct Resolution {
  double omega = 0.0;       ///< [rad/s]
  double wavelength = 0.0;  ///< of the incident wave [m]
  /// Of the flexural-gravity wave along the plate, in the region with the fewest nodes a wave [m].
  double flexural_wavelength = std::numeric_limits<double>::infinity();
  double nodes_per_wavelength = 0.0;
  double nodes_per_flexural_wavelength = std::numeric_limits<double>::infinity();
  double least_nodes() const {
    return nodes_per_wavelength < nodes_per_flexural_wavelength ? nodes_per_wavelength
                                                                : nodes_per_flexural_wavelength;
  }
};

inline constexpr double kNodesWanted = 4.0;    ///< fewer a wavelength: a warning
inline constexpr double kNodesRequired = 2.0;  ///< fewer: refused, unless the case allows it
/// Fewer: refused always. Such a result would be noise, and the Green function's table, which grows
/// with the mesh's size in wavelengths, would fill any memory.
inline constexpr double kNodesAtLeast = 0.1;

struct Preflight {
  mesh::MeshQuality quality;
  std::vector<Resolution> resolution;  ///< one a frequency of the case
  std::vector<std::string> warnings;
  std::string few_modes;  ///< that one of the warnings; empty where there are enough
};

/// Looks at the mesh (and the plate's own mesh, if it has one) against all waves of the case; in
/// each region of the plate against its own. Without `regions` the plate is uniform.
/// Warns about fewer than 4 nodes a wavelength, elements with an aspect ratio over 20, edge lengths
/// that jump by more than 10 between neighbours, plates thicker than a fifth of the shorter side of
/// the mesh, and a mesh whose size and wavelengths differ by
/// more than 1e4 (a mesh in millimetres).
Preflight preflight(const Case& data, const mesh::Q8Mesh& mesh,
                    const mesh::Q8Mesh* plate_mesh = nullptr,
                    const plate::PlateRegions* regions = nullptr);

/// The same of the frequencies that were solved for the seas; the meshes and the regions as above.
std::vector<Resolution> sea_resolution(const Case& data,
                                       const std::vector<SolvedSeaFrequency>& solved,
                                       const mesh::Q8Mesh& mesh, const mesh::Q8Mesh* plate_mesh,
                                       const plate::PlateRegions* regions);

/// Throws InputError when a frequency has fewer than 2 nodes a wavelength and the case does not
/// allow it, or fewer than 0.1.
void require_resolution(const Case& data, const Preflight& found);

/// Throws what a run would throw later on. InputError: a point or a station of a line lies on no
/// plate (the first is named), there are fewer modes than three a plate or more than half the
/// unknowns, or the direct route meets a frequency at which the plate's inertia outweighs the
/// water's stiffness. MeshError: the plate's own mesh leaves out a node of the fluid's, or the case
/// wants the lattice's method and the mesh is none.
void require_fit(const Case& data, const mesh::Q8Mesh& mesh, const mesh::Q8Mesh* plate_mesh,
                 const plate::PlateRegions& regions);

}  // namespace floe
