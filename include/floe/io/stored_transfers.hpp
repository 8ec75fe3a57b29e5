#pragma once

#include <floe/io/stored_run.hpp>

#include <vector>

namespace floe::io {

/// The transfer functions of a stored run for any sea: those of its seas' stage, or else those of
/// `[waves]`, if its headings go equidistantly around the circle.
class StoredTransfers {
 public:
  /// Keeps a view of the run. Throws StoreError when it has neither, saying what is required.
  explicit StoredTransfers(const StoredRun& run);

  const SeaObservation& observation() const { return observation_; }
  const SeaGridReport& grid() const { return grid_; }
  SeaTransfer transfer(std::size_t place) const;  ///< at the frequency of that place in the grid
  /// What is doubtful about them, one sentence each.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void take_from_waves();

  const StoredRun& run_;  // view
  SeaObservation observation_;
  SeaGridReport grid_;
  std::vector<SeaTransfer> of_waves_;  // empty where the seas' stage is there
  std::vector<std::string> warnings_;
};

}  // namespace floe::io
