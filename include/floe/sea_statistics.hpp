#pragma once

#include <floe/analysis.hpp>
#include <floe/response/pseudo_excitation.hpp>
#include <floe/sea_results.hpp>

#include <vector>

namespace floe {

/// Holds a sea against the frequencies that are computed [rad/s]: a warning where more than 1 % of
/// its m0 lie outside, DataError for more than 5 % unless the sea allows it. `remedy` ends with
/// what helps.
void require_band(const wave::SeaState& sea, double from, double to, const std::string& remedy,
                  Log& log);

/// Statistics of any number of seas while the transfer functions pass by, one frequency at a time:
/// nothing of them is kept but a few q × q matrices and the spectra at points.
class SeaStatistics {
 public:
  /// Every mean heading of every sea. `omega` are the frequencies to come, ascending [rad/s];
  /// `headings` those of a transfer function on the full circle.
  SeaStatistics(const std::vector<wave::SeaState>& seas, SeaObservation observation,
                std::vector<double> omega, int headings);

  ~SeaStatistics();

  /// The frequencies in order, none left out; throws InputError otherwise.
  void add(const SeaTransfer& transfer);

  /// One result for every sea and mean heading, in the order of the seas.
  std::vector<SeaResult> results() const;

 private:
  struct Sum;
  SeaResult result_of(const Sum& sum) const;
  void add_spectra(const MatXd& spectra, SeaResult& result) const;
  double grid_error(const VecXd& spectrum, double integral) const;

  std::vector<wave::SeaState> seas_;
  SeaObservation observation_;
  std::vector<double> omega_, weight_;
  std::vector<Sum> sums_;
};

}  // namespace floe
