#pragma once

#include <floe/analysis.hpp>
#include <floe/response/pseudo_excitation.hpp>
#include <floe/sea_results.hpp>

#include <functional>
#include <string>
#include <vector>

namespace floe {

/// Holds a sea against the frequencies that are computed [rad/s]: a warning where more than 1 % of
/// its m0 lie outside, DataError for more than 5 % unless the sea allows it. `remedy` ends with
/// what helps.
void require_band(const wave::SeaState& sea, double from, double to, const std::string& remedy,
                  Log& log);

/// Share of a sea's m0 beyond the band from which on a warning tells it.
inline constexpr double kShareTold = 0.01;

/// A warning for each end of the frequencies where the spectrum of a response is still more than a
/// quarter of its largest value: the peak may lie beyond. It names the worst point and quantity.
std::vector<std::string> cut_responses(const SeaResult& result, const Case& data);

/// Takes the spectrum of the deflection at all nodes [m² s/rad], of one frequency and one of the
/// results, by its place among them.
using NodeSpectrumSink = std::function<void(std::size_t result, const VecXd& spectrum)>;

/// Statistics of any number of seas while the transfer functions pass by, one frequency at a time:
/// nothing of them is kept but a few q × q matrices and the spectra at points.
class SeaStatistics {
 public:
  /// Every mean heading of every sea. `omega` are the frequencies to come, ascending [rad/s];
  /// `headings` those of a transfer function on the full circle. `relations` may be empty.
  SeaStatistics(const std::vector<wave::SeaState>& seas, SeaObservation observation,
                std::vector<double> omega, int headings, const SeaRelations& relations = {});

  ~SeaStatistics();

  /// The frequencies in order, none left out; throws InputError otherwise.
  /// With a sink the spectra of all nodes are made and handed on; nothing of them is kept.
  void add(const SeaTransfer& transfer, const NodeSpectrumSink& sink = {});

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
