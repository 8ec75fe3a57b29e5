#pragma once

#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/types.hpp>

#include <span>
#include <vector>

namespace floe::hydro {

/// S_mn = ∫ N_m N_n dS [m²], N × N: ∫ a b dS = aᵀ S b for fields given by nodal values.
SparseMatrix surface_mass(const mesh::Q8Mesh& mesh);

/// Nodal values of the incident elevation e^{ik(x cos β + y sin β)} per metre of amplitude (H.2),
/// one column a heading β [rad].
MatXcd incident_elevation(const Points2& points, double wavenumber,
                          std::span<const double> heading);

/// s_m(β) = ∫ N_m e^{ik(x cos β + y sin β)} dS [m²], one column a heading β [rad]: the wave itself
/// is integrated, by as many Gauss points as its length needs, not its nodal interpolant.
MatXcd wave_loads(const mesh::Q8Mesh& mesh, double wavenumber, std::span<const double> heading);

/// `count` equidistant headings over the full circle, from 0 [rad].
std::vector<double> full_circle(int count);

}  // namespace floe::hydro
