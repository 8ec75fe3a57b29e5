#pragma once

#include <floe/frequency_report.hpp>
#include <floe/numeric/types.hpp>
#include <floe/wave/sea_state.hpp>

#include <optional>
#include <string>
#include <vector>

namespace floe {

/// A quantity at a point of the case, by their places in Case::points and Case::quantities.
struct PointQuantity {
  std::size_t point = 0;
  std::size_t quantity = 0;
};

/// Two quantities whose cross-spectrum is wanted.
struct QuantityPair {
  PointQuantity first, second;
};

struct CombinationTerm {
  PointQuantity of;
  double factor = 1.0;
};

/// Several quantities as one: their weighted sum, or the stress √(σx² + σy² - σxσy + 3τ²) of von
/// Mises from three terms σx, σy, τ.
struct Combination {
  enum class Kind { kSum, kVonMises };
  std::string name;
  Kind kind = Kind::kSum;
  std::vector<CombinationTerm> terms;
};

/// What is told of several quantities at once.
struct SeaRelations {
  std::vector<QuantityPair> pairs;
  std::vector<Combination> combinations;
  bool empty() const { return pairs.empty() && combinations.empty(); }
};

/// Over which frequencies seas are integrated. What is not given is chosen: the band that holds all
/// but 0.1 % of every sea's m0 below and 0.5 % above, as far as the mesh has 4 nodes a wavelength.
struct SeaGrid {
  std::optional<double> from;  ///< [rad/s]
  std::optional<double> to;    ///< [rad/s]
  double tolerance = 1e-3;     ///< of the response between solved frequencies, estimated
};

/// What the statistics of any sea need to know of the structure. The state of a wave is ξ, for
/// every section force at a point what the modes leave out of it (E.12), and the pressure at every
/// point where one is asked for (R.4): q + m numbers.
struct SeaObservation {
  std::vector<std::size_t> quantity;  ///< positions in Case::quantities
  std::vector<int> derivative;        ///< in time, one a quantity
  std::vector<double> phase;          ///< of its constant factor, one a quantity [rad]
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

/// A frequency that was solved for the seas, and what its solution is worth.
struct SolvedSeaFrequency {
  FrequencyReport report;       ///< of the modes' radiation; no wall time
  double pressure_error = 0.0;  ///< of the pressures at points by (R.4), relative to the largest
  /// ‖ξ‖ of waves of one metre from all around, times the root of the density of the sea that has
  /// the largest share of its energy there: the weight of this frequency in the seas.
  double response = 0.0;
};

/// Radiation pressures and fluid matrix of one frequency, from which the fluid at others is told.
struct FluidSample {
  double omega = 0.0;   ///< [rad/s]
  MatXcd pressure;      ///< p_i, N × (q + m)
  MatXcd fluid_matrix;  ///< P, (q + m) × (q + m)
  SolvedSeaFrequency solved;
};

/// How far the seas have come: the transfer functions that are done, and what the way to the next
/// ones needs, so that it goes on with the same bits.
struct SeaMarch {
  std::size_t next = 0;                  ///< place of the first transfer function not yet done
  Index interval = 0;                    ///< of the samples, its lower end
  double step = 0.0;                     ///< [rad/s]
  int solved = 0;                        ///< samples so far
  double largest_error = 0.0;            ///< (E.10) over the intervals done
  std::vector<int> samples;              ///< numbers of the samples that are needed, by rising ω
  std::vector<double> largest_response;  ///< one a quantity and the deflection as a whole
  std::vector<SolvedSeaFrequency> all_solved;  ///< all samples so far, in their order
};

/// How the transfer functions between the solved frequencies came about.
struct SeaGridReport {
  std::vector<double> omega;         ///< all frequencies of the transfer functions [rad/s]
  int headings = 0;                  ///< on the full circle
  double interpolation_error = 0.0;  ///< largest (E.10) of an interval
  int solved_frequencies = 0;
  double pressure_error = 0.0;             ///< largest of a pressure at a point by (R.4), relative
  std::vector<SolvedSeaFrequency> solved;  ///< in the order in which they were solved
};

/// Of one of SeaRelations::pairs.
struct PairResult {
  VecXcd spectrum;           ///< (R.5) at the frequencies [product of the units, s/rad]
  double covariance = 0.0;   ///< at the same time
  double correlation = 0.0;  ///< 0 where one does not move
};

/// Of one of SeaRelations::combinations.
struct CombinationResult {
  VecXd spectrum;                      ///< [unit² s/rad]
  VecXd moments;                       ///< m0, m1, m2, m4
  double most_probable_maximum = 0.0;  ///< of the storm: (E.11) of a sum, (R.7) of a stress
};

/// Statistics of one sea from one mean heading.
struct SeaResult {
  std::string sea;
  double mean_heading_deg = 0.0;
  std::vector<double> omega;          ///< where the spectra are told [rad/s]
  std::vector<std::size_t> quantity;  ///< positions in Case::quantities
  std::vector<MatXd> spectra;         ///< one a quantity: points × frequencies [unit² s/rad]
  std::vector<MatXd> moments;         ///< one a quantity: points × (m0, m1, m2, m4)
  VecXd line_deviation;               ///< of the deflection, stations of all lines in order [m]
  MatXd node_moments;                 ///< of the deflection, nodes of the mesh × (m0, m1, m2, m4)
  std::vector<PairResult> pairs;      ///< as in SeaRelations
  std::vector<CombinationResult> combinations;
  double duration = 0.0;            ///< of the storm [s]
  double significant_height = 0.0;  ///< 4√m0 of the waves, all frequencies [m]
  double share_outside = 0.0;       ///< of the sea's m0, beyond the band
  double grid_error = 0.0;          ///< of m0 at the points: every frequency against every other
  double spreading_sum = 1.0;       ///< ∑ D Δθ over the headings, the one farthest from 1
  double band_height = 0.0;         ///< 4√m0 of the waves as the frequencies sum it up [m]
};

}  // namespace floe
