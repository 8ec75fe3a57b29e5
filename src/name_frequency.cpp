#include "name_frequency.hpp"

#include <floe/mesh/mesh_quality.hpp>
#include <floe/wave/dispersion.hpp>

#include <fmt/format.h>

#include <numbers>

namespace floe {
namespace {

// Fewer lengthen the iterations: 129 steps with 4.9 nodes a wavelength, 244 with 4.6, more than 500
// with 4.0 (300 × 60 m, elements of 3 m, 30 modes)
constexpr double kNodesEnough = 6.0;

}  // namespace

void throw_at_frequency(const ConvergenceError& error, double omega, const wave::Water& water,
                        const mesh::Q8Mesh& mesh) {
  const double spacing = 0.5 * mesh::longest_edges(mesh).maxCoeff();
  const double nodes = 2.0 * std::numbers::pi / wave::wavenumber(omega, water) / spacing;
  const std::string coarse =
      nodes >= kNodesEnough
          ? ""
          : fmt::format("; the mesh has {:.2g} nodes per wavelength (refine it, {:g} are enough)",
                        nodes, kNodesEnough);
  throw ConvergenceError(fmt::format("omega = {} rad/s: {}{}", omega, error.what(), coarse));
}

}  // namespace floe
