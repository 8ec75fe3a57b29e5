#include "analysis_stages.hpp"

#include <floe/numeric/error.hpp>
#include <floe/wave/dispersion.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace floe {
namespace {

// Length of the waves with the mean frequency of a spectrum, the longest of all zones [m]
double longest_wave(const wave::SeaState& sea, const wave::Water& water) {
  double longest = 0.0;
  for (const wave::Partition& zone : sea.partitions) {
    const double omega = zone.spectrum.moment(1) / zone.spectrum.m0();
    longest = std::max(longest, 2.0 * std::numbers::pi / wave::wavenumber(omega, water));
  }
  return longest;
}

}  // namespace

MatXd all_zone_amplitudes(const std::vector<wave::SeaState>& seas, const mesh::Q8Mesh& mesh) {
  MatXd all(mesh.node_count(), 0);
  for (const wave::SeaState& sea : seas) {
    if (!sea.zones) continue;
    MatXd own;
    try {
      own = wave::zone_amplitudes(*sea.zones, mesh.nodes());
    } catch (const InputError& error) {
      throw DataError(fmt::format("sea {}: {}", sea.name, error.what()));
    }
    all.conservativeResize(Eigen::NoChange, all.cols() + own.cols());
    all.rightCols(own.cols()) = own;
  }
  return all;
}

void check_zones(const Case& data, const mesh::Q8Mesh& mesh, Log& log) {
  all_zone_amplitudes(data.seas, mesh);
  for (const wave::SeaState& sea : data.seas) {
    if (!sea.zones) continue;
    const double longest = longest_wave(sea, data.water);
    if (sea.zones->transition < longest)
      log.warning(fmt::format(
          "sea {}: its zones pass into each other over {:.3g} m, but its waves are {:.3g} m long; "
          "waves that change within their length are none of the water's (widen transition)",
          sea.name, sea.zones->transition, longest));
  }
}

}  // namespace floe
