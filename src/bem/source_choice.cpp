#include "bem/source_choice.hpp"

#include <floe/numeric/error.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace floe::bem {
namespace {

// Measured against exact integrals, p without any order: the error of 𝒢p at the near radius in
// still water, and the factor of (kE)^power, E the longest edge, that waves add
struct Candidate {
  SourcePoints points;
  double near_radius, still_error, wave_factor;
  int wave_power;
};
constexpr Candidate kCandidates[] = {
    {SourcePoints::kNodes, 2.0, 7e-4, 1e-3, 3},    {SourcePoints::kNodes, 2.5, 4e-4, 1e-3, 3},
    {SourcePoints::kNodes, 3.0, 1.8e-4, 1e-3, 3},  {SourcePoints::kGauss3, 2.0, 1.3e-5, 7e-5, 4},
    {SourcePoints::kGauss3, 2.5, 7e-6, 7e-5, 4},   {SourcePoints::kGauss3, 3.0, 3e-6, 7e-5, 4},
    {SourcePoints::kGauss4, 2.0, 4e-8, 1.5e-7, 6}, {SourcePoints::kGauss4, 2.5, 2e-8, 1.5e-7, 6},
    {SourcePoints::kGauss5, 2.0, 1e-9, 3e-10, 8},  {SourcePoints::kGauss6, 2.0, 1e-9, 1e-12, 10},
};

}  // namespace

SourceChoice choose_sources(const mesh::Q8Mesh& mesh, double tolerance, double max_wavenumber) {
  double edge = 0.0;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(e);
    for (int side = 0; side < 4; ++side)
      edge = std::max(edge, (nodes.col(side) - nodes.col((side + 1) % 4)).norm());
  }
  const auto* found =
      std::find_if(std::begin(kCandidates), std::end(kCandidates), [&](const Candidate& candidate) {
        const double wave =
            candidate.wave_factor * std::pow(max_wavenumber * edge, candidate.wave_power);
        return candidate.still_error + wave <= 2.0 * tolerance;
      });
  FLOE_VALIDATE(found != std::end(kCandidates),
                "invalid wavenumber = " << max_wavenumber << " rad/m with elements of " << edge
                                        << " m (must be smaller for a tolerance of " << tolerance
                                        << "; refine the mesh, give a larger solver.tolerance, or "
                                           "solver.method = \"dense\" if it fits)");
  return {found->points, found->near_radius};
}

}  // namespace floe::bem
