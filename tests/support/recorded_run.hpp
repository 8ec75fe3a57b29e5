#pragma once

#include <floe/run_results.hpp>

/// Whole analyses in memory, for tests.
namespace floe::test {

using RecordedRun = RunResults;
using RecordingLog = MemoryLog;

inline RecordedRun run(const Case& data) { return analyse(data); }

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
