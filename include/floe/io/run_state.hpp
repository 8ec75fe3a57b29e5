#pragma once

#include <floe/analysis.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace floe::io {

/// How far a run is, as its directory tells.
struct RunState {
  enum class Part { kDone, kOpen, kFailed, kDamaged };
  struct Frequency {
    double omega = 0.0;  ///< [rad/s]
    Part part = Part::kOpen;
    double seconds = 0.0;        ///< wall time; 0 unless done
    double true_residual = 0.0;  ///< 0 unless done
    std::string failure = {};    ///< why it failed
  };

  std::string title;
  std::string status;  ///< as run.json has it; "stopped without notice" where nobody runs any more
  std::string holder;  ///< who runs it now: "process 123 on host"; "" if nobody does
  Shard shard;
  std::vector<Frequency> frequencies;  ///< of the shard
  bool seas_asked = false;
  bool seas_done = false;
  std::size_t transfers_done = 0;  ///< of an unfinished or finished sea stage
  std::size_t transfers = 0;       ///< 0 before it has begun
  /// Of what is open, from the times of what is done, or else as predicted; of one process.
  double seconds_left = 0.0;

  std::size_t count(Part part) const;
  bool complete() const {
    return count(Part::kDone) == frequencies.size() && (seas_done || !seas_asked);
  }
};

/// Looks without disturbing a run. Throws StoreError when the directory holds none.
RunState look_at_run(const std::filesystem::path& directory);

}  // namespace floe::io
