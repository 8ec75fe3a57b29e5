#pragma once

#include <floe/estimate.hpp>
#include <floe/run_results.hpp>
#include <floe/self_checks.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace floe::io {

/// A result directory of `floe run`, read back. Seas of the case are told by their results only.
class StoredRun {
 public:
  /// Reads what is small; throws StoreError when the directory holds no result of floe, or one of
  /// another version, or a record is damaged. `run.json` may be lost.
  explicit StoredRun(std::filesystem::path directory);

  const std::filesystem::path& directory() const { return directory_; }
  const Case& data() const { return data_; }                      ///< Case::seas is empty
  const std::string& case_text() const { return text_; }          ///< as the user wrote it
  const std::string& manifest_text() const { return manifest_; }  ///< records/manifest.json
  const std::string& account_text() const { return account_; }    ///< run.json; "" if it is lost
  const std::string& status() const { return status_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  const std::vector<StageTime>& stages() const { return stages_; }
  double seconds_before() const { return seconds_before_; }  ///< of runs that were resumed [s]
  /// What the run told about itself; empty where it did not come to its end.
  const std::vector<SelfCheck>& checks() const { return checks_; }
  int threads() const;      ///< that the run had; 1 if that is lost
  bool wants_seas() const;  ///< the case, or the shard, asks for them
  Estimate plan() const;    ///< what it was predicted to take
  /// One sentence a sea of the case, in its order.
  const std::vector<std::string>& sea_names() const { return sea_names_; }
  const std::vector<std::string>& sea_descriptions() const { return sea_descriptions_; }

  mesh::Q8Mesh fluid_mesh() const;
  mesh::Q8Mesh mode_mesh() const;  ///< the plate's own, or else the fluid's
  plate::DryModes modes() const;
  std::vector<FrequencyResult> frequencies() const;  ///< those that were finished
  /// Whether the one of that place in data().omega was finished; it, with its fields.
  bool has_frequency(std::size_t place) const;
  FrequencyResult frequency(std::size_t place) const;
  /// Why the one of that place could not be solved; "" where it was, or was not tried.
  std::string failure(std::size_t place) const;
  /// The same with `unsolved_frequency` where it could not be solved; nothing where it was not
  /// tried. `mode_count` is that of `modes()`, 0 on the direct route.
  std::optional<FrequencyResult> tried_frequency(std::size_t place, Index mode_count) const;
  std::vector<SeaResult> seas() const;
  /// All of these, frequencies as far as they were tried; without transfer functions and notices.
  RunResults results() const;

  /// Whether transfer functions for seas are there.
  bool has_transfers() const;
  SeaObservation observation() const;
  SeaGridReport sea_grid() const;
  std::optional<SeaGridReport> finished_seas() const;  ///< nothing unless they are all done
  SeaTransfer transfer(std::size_t place) const;  ///< at the frequency of that place in the grid

 private:
  std::filesystem::path record(const std::string& name) const;

  std::filesystem::path directory_;
  Case data_;
  std::string text_, status_, manifest_, account_;
  std::vector<std::string> warnings_, sea_names_, sea_descriptions_;
  std::vector<StageTime> stages_;
  double seconds_before_ = 0.0;
  std::vector<SelfCheck> checks_;
};

}  // namespace floe::io
