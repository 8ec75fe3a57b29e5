#pragma once

#include <floe/numeric/types.hpp>
#include <floe/wave/sea_state.hpp>

#include <optional>
#include <string>
#include <vector>

namespace floe {

/// Over which frequencies seas are integrated. What is not given is chosen: the band that holds all
/// but 0.1 % of every sea's m0 below and 0.5 % above, as far as the mesh has 4 nodes a wavelength.
struct SeaGrid {
  std::optional<double> from;  ///< [rad/s]
  std::optional<double> to;    ///< [rad/s]
  double tolerance = 1e-3;     ///< of the response between solved frequencies, estimated
};

/// Statistics of one sea from one mean heading. Quantities are those of the case that follow from
/// the displacement; pressures are left out.
struct SeaResult {
  std::string sea;
  double mean_heading_deg = 0.0;
  std::vector<double> omega;          ///< where the spectra are told [rad/s]
  std::vector<std::size_t> quantity;  ///< positions in Case::quantities
  std::vector<MatXd> spectra;         ///< one a quantity: points × frequencies [unit² s/rad]
  std::vector<MatXd> moments;         ///< one a quantity: points × (m0, m1, m2, m4)
  VecXd line_deviation;               ///< of the deflection, stations of all lines in order [m]
  VecXd node_deviation;               ///< of the deflection at the nodes of the plate's mesh [m]
  double share_outside = 0.0;         ///< of the sea's m0, beyond the band
  double grid_error = 0.0;            ///< of m0 at the points: every frequency against every other
  double interpolation_error = 0.0;   ///< largest (E.10) of an interval
  int solved_frequencies = 0;
};

}  // namespace floe
