#pragma once

#include <floe/analysis.hpp>

#include <optional>
#include <string>
#include <vector>

/// A run whose results stay in memory.
namespace floe {

/// All that a run gives.
struct RunResults {
  Case data;
  std::optional<mesh::Q8Mesh> fluid_mesh;
  std::optional<mesh::Q8Mesh> mode_mesh;  ///< the plate's own, or else the fluid's
  plate::DryModes modes;                  ///< on `mode_mesh`; none on the direct route
  std::vector<FrequencyResult> frequencies;
  SeaObservation observation;
  std::vector<SeaTransfer> transfers;
  std::vector<SeaResult> seas;
  SeaGridReport sea_grid;
  std::vector<StageTime> stages;
  std::vector<std::string> notices, warnings;
};

/// Keeps what `analyse` tells.
class MemoryStore final : public Store {
 public:
  /// Fills `results`, which must outlive the store.
  explicit MemoryStore(RunResults& results) : results_(results) {}
  void begin(const Case& data, const mesh::Q8Mesh& mesh, const Estimate& plan) override;
  void modes(const plate::DryModes& modes, const mesh::Q8Mesh& mesh) override;
  void frequency(const FrequencyResult& result) override;
  void begin_seas(const SeaObservation& observation, const SeaGridReport& planned) override;
  void sea_transfer(const SeaTransfer& transfer) override;
  void sea(const SeaResult& result) override;
  void end_seas(const SeaGridReport& grid) override;
  void finish(const std::vector<StageTime>& times) override;

 private:
  RunResults& results_;  // view
};

/// Keeps notices and warnings, and is silent otherwise.
class MemoryLog final : public Log {
 public:
  /// Fills `results`, which must outlive the log.
  explicit MemoryLog(RunResults& results) : results_(results) {}
  void info(const std::string&) override {}
  void notice(const std::string& text) override { results_.notices.push_back(text); }
  void warning(const std::string& text) override { results_.warnings.push_back(text); }
  void progress(double, const std::string&) override {}

 private:
  RunResults& results_;  // view
};

/// Runs the case silently; throws as the other `analyse`.
RunResults analyse(const Case& data);

}  // namespace floe
