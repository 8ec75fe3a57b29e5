#pragma once

#include <floe/bem/element_integrals.hpp>
#include <floe/green/green_table.hpp>
#include <floe/numeric/types.hpp>
#include <floe/wave/water.hpp>

namespace floe::hydro {

/// Elevation of the free surface, incident, diffracted and radiated waves together (H.8):
///   ζ_total(x) = ζ(x) - (κ/ρg) ∫_S G(|x - y|) p(y) dS
/// at `points` (2 × M [m]) anywhere, from the total pressure (N × headings) and the incident
/// elevation at the points (M × headings). On the plate it is w + p/ρg. Points × headings [m].
/// The table must reach from every point to every node.
MatXcd wave_elevation(const bem::ElementIntegrals& integrals, const green::GreenTable& green,
                      const wave::Water& water, const Points2& points,
                      const Eigen::Ref<const MatXcd>& incident,
                      const Eigen::Ref<const MatXcd>& total_pressure);

/// Far-field amplitude A(θ) of the scattered and radiated waves, ζ_s ~ A(θ) √(2/πkr) e^{i(kr-π/4)}:
///   A(θ) = -(κc/ρg) ∫ p e^{-ik(x cos θ + y sin θ)} dS                                  (H.9)
/// with c of (G.2). `wave_loads_reversed` is wave_loads at the headings θ + π. Without losses
/// (1/2π) ∫|A|² dθ = -Re A(β) in a wave of heading β (H.10). Angles × headings [m].
MatXcd far_field_amplitude(const green::GreenFunction& green, const wave::Water& water,
                           const MatXcd& wave_loads_reversed, const MatXcd& total_pressure);

}  // namespace floe::hydro
