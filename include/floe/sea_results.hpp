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

/// What the statistics of any sea need to know of the structure. The state of a wave is ξ and, for
/// every section force at a point, what the modes leave out of it (E.12): q + m numbers.
struct SeaObservation {
  std::vector<std::size_t> quantity;  ///< positions in Case::quantities
  std::vector<int> derivative;        ///< in time, one a quantity
  MatXd points;                       ///< (quantities · points) × (q + m), points run faster
  MatXd lines;                        ///< deflection at the stations of all lines × q
  MatXd nodes;                        ///< deflection at the nodes of the fluid's mesh × q
};

/// States of the waves of one frequency from all directions, per metre of wave.
struct SeaTransfer {
  double omega = 0.0;  ///< [rad/s]
  MatXcd state;        ///< (q + m) × headings, equidistant on the full circle, from 0
  /// The same of waves with the amplitudes of a zone (E.23): one a zone of every sea with zones, in
  /// their order.
  std::vector<MatXcd> zone_states = {};
};

/// How the transfer functions between the solved frequencies came about.
struct SeaGridReport {
  std::vector<double> omega;         ///< all frequencies of the transfer functions [rad/s]
  int headings = 0;                  ///< on the full circle
  double interpolation_error = 0.0;  ///< largest (E.10) of an interval
  int solved_frequencies = 0;
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
  MatXd node_moments;                 ///< of the deflection, nodes of the mesh × (m0, m1, m2, m4)
  double duration = 0.0;              ///< of the storm [s]
  double significant_height = 0.0;    ///< 4√m0 of the waves, all frequencies [m]
  double share_outside = 0.0;         ///< of the sea's m0, beyond the band
  double grid_error = 0.0;            ///< of m0 at the points: every frequency against every other
  double spreading_sum = 1.0;         ///< ∑ D Δθ over the headings, the one farthest from 1
  double band_height = 0.0;           ///< 4√m0 of the waves as the frequencies sum it up [m]
};

}  // namespace floe
