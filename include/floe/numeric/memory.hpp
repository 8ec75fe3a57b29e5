#pragma once

#include <filesystem>

/// How much memory a run may take, and how much it took.
namespace floe::numeric {

/// Bounds on the memory of this process [byte]; infinite where there is none.
struct MemoryLimits {
  double control_group = 0.0;  ///< smallest `memory.max` (cgroup v2) on the way to the root
  double address_space = 0.0;  ///< RLIMIT_AS
  double available = 0.0;      ///< MemAvailable: what the machine can give without swapping
};

/// Reads them. What cannot be read counts as no bound.
/// `root` is put before /proc and /sys (tests give a directory of their own).
MemoryLimits memory_limits(const std::filesystem::path& root = "/");

/// The budget [byte]: the least of `asked` (0: nothing was asked), the control group's limit, the
/// address-space limit and 80 % of what is available.
double memory_budget(double asked, const MemoryLimits& limits);

/// Largest resident memory of this process so far [byte].
double peak_memory();

}  // namespace floe::numeric
