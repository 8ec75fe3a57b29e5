#pragma once

#include <floe/analysis.hpp>
#include <floe/self_checks.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace floe::io {

/// What to do with a floe result that is there already.
enum class Existing {
  kRefuse,  ///< throw StoreError
  kResume,  ///< take over what an earlier run of the same case finished
  kReplace  ///< delete the files that floe made, and no others, when the new run begins
};

/// Results as files in one directory: CSV tables, node fields for ParaView, `run.json`, and under
/// `records/` what a later command needs of them (StoredRun reads it back). Tables grow
/// in temporary files beside their names and appear complete. `run.json` is there from the
/// beginning, lists all files of the run and says its status: "running", "complete", "failed" where
/// frequencies could not be solved, or why it stopped.
class DirectoryStore final : public Store {
 public:
  /// Makes the directory (not its parents), locks it and looks at what it holds; writes nothing
  /// yet. Throws FileError when it cannot be written, StoreError when it holds results or other
  /// files of the same names, BusyError when another run holds it.
  explicit DirectoryStore(const std::filesystem::path& directory,
                          Existing existing = Existing::kRefuse);
  /// Frees the directory; removes it if this run made it and nothing was stored.
  ~DirectoryStore() override;
  DirectoryStore(const DirectoryStore&) = delete;
  DirectoryStore& operator=(const DirectoryStore&) = delete;

  /// Of the earlier run, with kResume. A record that is missing is not known; one that is damaged
  /// is moved to records/bad/ and not known either.
  std::optional<plate::DryModes> known_modes() override;
  std::optional<FrequencyResult> known_frequency(std::size_t place) override;
  std::optional<SeaMarch> known_sea_march() override;
  std::optional<FluidSample> known_sea_sample(int number) override;
  std::optional<SeaGridReport> known_sea_grid() override;
  SeaTransfer known_transfer(std::size_t place) override;
  SeaObservation known_observation() override;
  /// Case::plan_memory of the earlier run, with kResume; 0 where there is none.
  double earlier_plan_memory() const;
  /// Whether a second run is kept out: some network file systems have no locks.
  bool locks() const;
  /// One sentence a record that was found damaged.
  const std::vector<std::string>& damaged_records() const;

  /// What the results tell about themselves, once the run has ended.
  const std::vector<SelfCheck>& checks() const;

  /// With kResume throws StoreError, naming what differs, when the earlier run was of another case.
  /// Keeps a view of `mesh` until `finish` or `stop`.
  void begin(const Case& data, const mesh::Q8Mesh& mesh, const Estimate& plan) override;
  void modes(const plate::DryModes& modes, const mesh::Q8Mesh& mesh) override;
  void frequency(const FrequencyResult& result) override;
  void begin_seas(const SeaObservation& observation, const SeaGridReport& planned) override;
  void sea_sample(int number, const FluidSample& sample) override;
  void sea_march(const SeaMarch& march) override;
  void sea_transfer(const SeaTransfer& transfer) override;
  void node_spectrum(std::size_t result, std::size_t frequency, const VecXd& spectrum) override;
  void sea(const SeaResult& result) override;
  void end_seas(const SeaGridReport& grid) override;
  void finish(const std::vector<StageTime>& times) override;

  /// Ends a run that did not come to `finish`: keeps the products of all finished frequencies and
  /// writes `status` to `run.json`; with no frequency finished, removes what the run had written.
  /// Nothing after `finish`.
  void stop(const std::string& status);

  /// Files of the run so far, relative to the directory.
  const std::vector<std::string>& files() const;
  const std::filesystem::path& directory() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace floe::io
