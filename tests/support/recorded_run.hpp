#pragma once

#include <floe/analysis.hpp>

#include <string>
#include <vector>

/// Whole analyses in memory, for tests.
namespace floe::test {

/// All that a run gives.
struct RecordedRun {
  Case data;
  plate::DryModes modes;
  std::vector<FrequencyResult> frequencies;
  SeaObservation observation;
  std::vector<SeaTransfer> transfers;
  std::vector<SeaResult> seas;
  SeaGridReport sea_grid;
  std::vector<std::string> notices, warnings;
};

class RecordingStore final : public Store {
 public:
  explicit RecordingStore(RecordedRun& run) : run_(run) {}
  void begin(const Case& data, const mesh::Q8Mesh&, const Estimate&) override { run_.data = data; }
  void modes(const plate::DryModes& modes, const mesh::Q8Mesh&) override { run_.modes = modes; }
  void frequency(const FrequencyResult& result) override { run_.frequencies.push_back(result); }
  void begin_seas(const SeaObservation& given, const SeaGridReport&) override {
    run_.observation = given;
  }
  void sea_transfer(const SeaTransfer& given) override { run_.transfers.push_back(given); }
  void end_seas(const SeaGridReport& given) override { run_.sea_grid = given; }
  void sea(const SeaResult& result) override { run_.seas.push_back(result); }
  void finish(const std::vector<StageTime>&) override {}

 private:
  RecordedRun& run_;
};

class RecordingLog final : public Log {
 public:
  explicit RecordingLog(RecordedRun& run) : run_(run) {}
  void info(const std::string&) override {}
  void notice(const std::string& text) override { run_.notices.push_back(text); }
  void warning(const std::string& text) override { run_.warnings.push_back(text); }
  void progress(double, const std::string&) override {}

 private:
  RecordedRun& run_;
};

inline RecordedRun run(const Case& data) {
  RecordedRun recorded;
  RecordingStore store(recorded);
  RecordingLog log(recorded);
  analyse(data, log, store);
  return recorded;
}

/// The paper's plate of Table 1 on nx × ny elements; waves are left to the test.
inline Case table1_case(int nx, int ny) {
  Case data;
  data.water = {.depth = 58.5, .density = 1025.0, .gravity = 9.81};
  data.plate = {
      .thickness = 2.0, .youngs_modulus = 1.19e10, .poisson_ratio = 0.13, .density = 256.25};
  data.mesh = mesh::RectangleOptions{.length = 300.0, .width = 60.0, .nx = nx, .ny = ny};
  data.points = {{"P1", {-150.0, -30.0}},
                 {"P2", {150.0, -30.0}},
                 {"P3", {150.0, 30.0}},
                 {"P4", {-150.0, 30.0}},
                 {"P5", {0.0, 0.0}}};
  return data;
}

}  // namespace floe::test
