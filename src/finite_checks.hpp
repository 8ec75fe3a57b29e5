#pragma once

#include <floe/analysis.hpp>

namespace floe {

/// Throws ConvergenceError naming the array where a result holds a number that is not finite: no
/// such number may be stored.
void require_finite(const FrequencyResult& result);

/// The same of the states of a sea's waves, naming the frequency too.
void require_finite(const SeaTransfer& transfer);

}  // namespace floe
