#pragma once

#include <floe/mesh/q8_mesh.hpp>
#include <floe/numeric/error.hpp>
#include <floe/wave/water.hpp>

namespace floe {

/// Throws the error again with the frequency before it; where the mesh has few nodes a wavelength
/// of the water's wave, which is why iterations fail, also with this.
[[noreturn]] void throw_at_frequency(const ConvergenceError& error, double omega,
                                     const wave::Water& water, const mesh::Q8Mesh& mesh);

/// What `solve` returns. A ConvergenceError of it gets the frequency [rad/s] it happened at.
template <typename Solve>
auto name_frequency(double omega, const wave::Water& water, const mesh::Q8Mesh& mesh,
                    const Solve& solve) {
  try {
    return solve();
  } catch (const ConvergenceError& error) {
    throw_at_frequency(error, omega, water, mesh);
  }
}

}  // namespace floe
