#pragma once

#include <floe/bem/pressure_operator.hpp>
#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/types.hpp>
#include <floe/wave/water.hpp>

#include <span>

namespace floe::hydro {

/// Pressures and coefficients of the modes, unit amplitude, one frequency.
struct Radiation {
  MatXcd pressure;      ///< p_j = -ρg (I + κ𝒢)⁻¹ w_j, N × q [Pa/m of mode]           (H.3)
  MatXcd fluid_matrix;  ///< P_ij = ∫ w_i p_j dS = ω²a + iωb - ρg ∫ w_i w_j dS, q × q  (H.4)
  MatXd added_mass;     ///< a, q × q
  MatXd damping;        ///< b, q × q
  double true_residual = 0.0;  ///< largest ‖b - Ax‖/‖b‖ of a column, recomputed
  bem::SolveReport work;       ///< the recomputed residual included
};

/// Solves the radiation problems of all modes, paper (13b), (15)–(17). `deflection` is w, N × q;
/// `surface_mass` is that of the same mesh. Throws ConvergenceError when a result is not finite or
/// a residual exceeds `residual_limit`, naming the mode.
Radiation solve_radiation(const bem::PressureOperator& pressure_operator,
                          const Eigen::Ref<const MatXd>& deflection,
                          const SparseMatrix& surface_mass, double omega, const wave::Water& water,
                          double residual_limit);

/// Wave pressure on the fixed plate p_ζ = ρg (I + κ𝒢)⁻¹ ζ (H.5), N × headings [Pa/m]; `elevation`
/// holds nodal values of any incident elevation, one column each. Throws as solve_radiation.
MatXcd solve_diffraction(const bem::PressureOperator& pressure_operator,
                         const Eigen::Ref<const MatXcd>& elevation, const wave::Water& water,
                         double residual_limit);

/// Exciting forces by reciprocity (Haskind), F_i(β) = -∫ p_i ζ dS (H.6), paper (18), q × headings:
/// from the radiation pressures (N × q) and wave_loads (N × headings), without a diffraction solve.
MatXcd exciting_forces(const MatXcd& radiation_pressure, const MatXcd& wave_loads);

/// The same the direct way, F_i(β) = ∫ w_i p_ζ dS: the check of the above.
MatXcd exciting_forces_direct(const Eigen::Ref<const MatXd>& deflection,
                              const SparseMatrix& surface_mass, const MatXcd& wave_pressure);

/// Froude–Krylov forces: of the incident wave's own pressure ρgζ, as if nothing disturbed it
/// (H.11), F_i(β) = ρg ∫ w_i ζ dS, q × headings; the rest of the exciting force is diffraction.
MatXcd froude_krylov_forces(const Eigen::Ref<const MatXd>& deflection, const MatXcd& wave_loads,
                            const wave::Water& water);

/// Damping from the energy that the modes radiate (H.7):
///   b_ij = k/(8πρg c_g) ∫ X_i X_j* dβ over all headings, X = F per metre of wave,
/// by 2kR + 20 equidistant headings or more, R half the diagonal. Independent of the imaginary part
/// of the fluid matrix. q × q.
MatXd radiated_damping(const Eigen::Ref<const MatXcd>& radiation_pressure, const mesh::Q8Mesh& mesh,
                       double omega, const wave::Water& water);

/// Largest |b_ij - b̂_ij| relative to √(s_i s_j), s_i the larger of b_ii and ω|a_ii|.
double energy_error(const Radiation& radiation, const MatXd& radiated, double omega);

/// Most negative eigenvalue of the damping matrix's symmetric part over its largest, sign turned: 0
/// where every motion loses energy. NaN where the damping is not finite.
double passivity_error(const Radiation& radiation);

/// ‖Q - Qᵀ‖ / ‖Q‖ of the hydrodynamic part Q = ω²a + iωb: 0 in exact arithmetic on a fine mesh.
double reciprocity_error(const Radiation& radiation, double omega);

}  // namespace floe::hydro
