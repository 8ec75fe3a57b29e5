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
/// is integrated, by as many Gauss points as its length needs (error 1e-9 of an element's area),
/// not its nodal interpolant.
MatXcd wave_loads(const mesh::Q8Mesh& mesh, double wavenumber, std::span<const double> heading);

/// ∫ f e^{ik(x cos β + y sin β)} dS of fields given by nodal values (N × q) for the headings of
/// `full_circle(count)`, count even: q × count. What wave_loads would give, without its N × count
/// numbers; opposite headings share the work.
MatXcd full_circle_transform(const mesh::Q8Mesh& mesh, double wavenumber, int count,
                             const Eigen::Ref<const MatXcd>& field);

/// `count` equidistant headings over the full circle, from 0 [rad].
std::vector<double> full_circle(int count);

}  // namespace floe::hydro
