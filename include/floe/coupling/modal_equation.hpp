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

}  // namespace floe::coupling
