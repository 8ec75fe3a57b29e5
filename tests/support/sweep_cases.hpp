#pragma once

#include "test_case.hpp"

#include <ostream>
#include <string>

/// Small sweeps of both routes, one with seas, for tests that run the program many times.
namespace floe::test {

struct SweepCase {
  std::string name;
  std::string rest;  ///< sections after [waves]

  /// The case with so many frequencies from 0.2 to 0.6 rad/s.
  std::string text(int count) const {
    return with("[0.4, 0.5]", "{ from = 0.2, to = 0.6, count = " + std::to_string(count) + " }") +
           rest;
  }
};

inline std::ostream& operator<<(std::ostream& out, const SweepCase& sweep) {
  return out << sweep.name;
}

/// With everything that a sea can ask for: pressures, pairs, combinations, spectra of all nodes.
inline const SweepCase kModalWithSeas = {"ModalWithSeas", R"([modes]
count = 6
[sea_grid]
omega = { from = 0.4, to = 0.6 }
tolerance = 0.02
[[sea]]
name = "design"
spectrum = "bretschneider"
significant_height = 2.0
significant_period = 12.0
spreading = "cos2"
mean_heading_deg = [0, 30]
allow_truncation = true
[output]
points = { P1 = [-150, -30], P5 = [10, 0] }
wave_points = { lee = [200, 0] }
lines = { middle = { from = [-150, 0], to = [150, 0], count = 5 } }
quantities = ["deflection", "bending_moment_x", "pressure"]
node_spectra = true
)"};

inline const SweepCase kDirect = {"Direct", R"([solver]
route = "direct"
[output]
points = { P1 = [-150, -30], P5 = [10, 0] }
wave_points = { lee = [200, 0] }
lines = { middle = { from = [-150, 0], to = [150, 0], count = 5 } }
quantities = ["deflection", "bending_moment_x", "pressure"]
)"};

}  // namespace floe::test
