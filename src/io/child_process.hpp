#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace floe::io {

/// What a child process may use up.
struct ChildLimits {
  double seconds = 30.0;                        ///< of wall time, and of its processor
  std::size_t memory = std::size_t{1} << 30;    ///< beyond what the process has now [byte]
  std::size_t result = std::size_t{256} << 20;  ///< size of what it gives back [byte]
};

/// Runs `work` in a child process and gives back its text: for libraries that a damaged file can
/// crash or hang. The child writes to no terminal and no file, and ends with this process.
/// Throws InputError with the work's own message when it throws, or with what became of the child:
/// a signal, too much time, memory or result.
std::string run_in_child(const std::function<std::string()>& work, const ChildLimits& limits = {});

}  // namespace floe::io
