#pragma once

#include <floe/analysis.hpp>

#include <string>
#include <vector>

/// Frequencies that could not be solved.
namespace floe {

/// In place of a result: arrays of the shapes that it would have, with `mode_count` modes (0 on the
/// direct route), all NaN; no node fields. Its report tells `failure`.
FrequencyResult unsolved_frequency(const Case& data, Index mode_count, double omega,
                                   std::string failure);

/// "2 of 5 frequencies have no result: omega = 4 rad/s: …; the same at 4.1 rad/s". `reports` are of
/// all that were tried; "" where all of them are solved.
std::string describe_unsolved(const std::vector<FrequencyReport>& reports);

}  // namespace floe
