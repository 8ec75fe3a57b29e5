#pragma once

#include <floe/response/cross_spectra.hpp>
#include <floe/sea_results.hpp>

#include <vector>

namespace floe {

/// What is asked of several quantities at once, in one sea from one mean heading, while its
/// pseudo-excitations pass by.
class RelationSums {
 public:
  RelationSums(const SeaRelations& relations, const SeaObservation& observation);

  /// One frequency [rad/s]: see response::pseudo_amplitudes.
  void add(double omega, const MatXcd& pseudo);

  /// Fills in SeaResult::pairs and SeaResult::combinations. `weight` is that of the frequencies in
  /// an integral over ω; `result` holds them and the duration already.
  void tell(const std::vector<double>& weight, SeaResult& result) const;

 private:
  Index place_of(const PointQuantity& wanted, const SeaObservation& observation);
  std::vector<MatXcd> of_terms(const Combination& combination, std::size_t number) const;

  SeaRelations relations_;
  std::vector<PointQuantity> quantities_;  // each once
  std::vector<Index> row_;                 // of SeaObservation::points, one each
  std::vector<int> derivative_;
  std::vector<double> phase_;
  std::vector<std::pair<Index, Index>> pair_;    // places in quantities_
  std::vector<std::vector<Index>> term_;         // likewise, one list a combination
  std::vector<response::CrossSpectra> spectra_;  // one, once the rows are known
};

}  // namespace floe
