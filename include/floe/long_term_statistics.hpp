#pragma once

#include <floe/analysis.hpp>
#include <floe/response/long_term.hpp>
#include <floe/sea_results.hpp>
#include <floe/wave/scatter_diagram.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace floe {

/// A class of a scatter diagram from one mean heading.
struct SeaClass {
  double height = 0.0;  ///< Hs [m]
  double period = 0.0;  ///< of the diagram's type [s]
  double mean_heading_deg = 0.0;
  double share = 0.0;  ///< of all time, or of the peaks beyond a level
};

/// Long-term statistics of one wave climate.
struct LongTermResult {
  wave::WaveClimate climate;
  std::vector<std::size_t> quantity;  ///< positions in Case::quantities
  /// Short-term moments per metre of significant height: one a quantity, points × (headings ·
  /// periods), periods run faster. Those of a class are Hs² times them.
  std::vector<MatXd> m0, m2;
  std::vector<double> share_outside;  ///< of m0 of the waves beyond the band, one a period
  double grid_error = 0.0;            ///< largest error of a period's m0 from the frequencies' step

  /// Energy of all waves beyond the band, as a share.
  double energy_outside() const;
  /// Of one quantity (by place in `quantity`) at one point.
  response::LongTermDistribution distribution(std::size_t quantity, Index point) const;
  /// The class that most of its peaks beyond `level` come from.
  SeaClass worst_class(std::size_t quantity, Index point, double level) const;
};

/// Holds a climate against the frequencies that are computed [rad/s]: a warning where more than 1 %
/// of the energy of all its waves lie outside, DataError for more than 5 % unless it allows it.
void require_band(const wave::WaveClimate& climate, double from, double to,
                  const std::string& remedy, Log& log);

/// Long-term statistics of any number of climates while the transfer functions pass by. What a sea
/// of 1 m does is summed for each mean heading and period; the classes of a diagram cost nothing.
class LongTermStatistics {
 public:
  /// `omega` are the frequencies to come, ascending [rad/s]; `headings` those of a transfer
  /// function on the full circle.
  LongTermStatistics(std::vector<wave::WaveClimate> climates, SeaObservation observation,
                     std::vector<double> omega, int headings);
  ~LongTermStatistics();

  /// The frequencies in order, none left out; throws InputError otherwise.
  void add(const SeaTransfer& transfer);

  /// One result for every climate, in their order.
  std::vector<LongTermResult> results() const;

 private:
  struct Sum;

  SeaObservation observation_;
  std::vector<double> omega_, weight_;
  std::size_t added_ = 0;
  std::vector<Sum> sums_;
};

}  // namespace floe
