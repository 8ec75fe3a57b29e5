#pragma once

#include <floe/numeric/types.hpp>
#include <floe/plate/dry_modes.hpp>

namespace floe::coupling {

/// Modal amplitudes ξ, q × headings, per metre of wave (C.2), paper (19)–(21):
///   [diag(ω_i²)(1 - iη) - ω² CᵀMC - P(ω)] ξ = F(ω, β)
/// with the fluid matrix P (q × q), the exciting forces F (q × headings) and the loss factor η.
/// Throws ConvergenceError when the matrix is singular to working precision (an undamped
/// resonance).
MatXcd modal_amplitudes(const plate::DryModes& modes, double loss_factor, double omega,
                        const MatXcd& fluid_matrix, const MatXcd& exciting_force);

/// What the highest quarter of the elastic modes changes: the largest change of w = Cξ over the
/// rows of `shape` (any × q) and the headings when they are left out of the equation, relative to
/// the largest |w|. The change under more modes, told from those that are there: as w converges,
/// the next ones bring less. 0 with fewer than four elastic modes.
double change_by_last_modes(const plate::DryModes& modes, double loss_factor, double omega,
                            const MatXcd& fluid_matrix, const MatXcd& exciting_force,
                            const MatXcd& amplitudes, const Eigen::Ref<const MatXd>& shape);

}  // namespace floe::coupling
