#pragma once

#include <floe/bem/element_integrals.hpp>
#include <floe/bem/pressure_operator.hpp>
#include <floe/green/green_table.hpp>
#include <floe/numeric/types.hpp>
#include <floe/wave/water.hpp>

namespace floe::hydro {

/// Fields u_x by which the wave pressure at points x of the plate follows for every heading from
/// one solve a point (R.4):
///   p_ζ(x) = ρg ζ(x) - ∫_S u_x ζ dS,   (I + κ𝒢) u_x = ρg κ G(|x - ·|)
/// N × points [Pa/m³]. G is replaced by its best fit of nodal functions, the transposed operator by
/// the operator itself: p_ζ(x) is that of solve_diffraction up to the discretisation error of both.
/// Throws ConvergenceError as solve_diffraction.
MatXcd wave_pressure_influence(const bem::PressureOperator& pressure_operator,
                               const bem::ElementIntegrals& integrals,
                               const green::GreenTable& green, const SparseMatrix& surface_mass,
                               const Points2& points, const wave::Water& water,
                               double residual_limit);

}  // namespace floe::hydro
