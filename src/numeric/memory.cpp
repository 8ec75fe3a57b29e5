#include <floe/numeric/memory.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace floe::numeric {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

// The number in a memory.max file; "max" and unreadable files are no bound
double read_bound(const std::filesystem::path& file) {
  std::ifstream in(file);
  double bytes = 0.0;
  return in >> bytes ? bytes : kUnbounded;
}

// Path of this process in the cgroup v2 tree: the line "0::/path"
std::string control_group_path(const std::filesystem::path& file) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("0::/")) return line.substr(4);
  return "";
}

double control_group_limit(const std::filesystem::path& root) {
  const std::filesystem::path top = root / "sys/fs/cgroup";
  std::filesystem::path group = top / control_group_path(root / "proc/self/cgroup");
  double least = kUnbounded;
  // Every group on the way up can bound the memory
  for (int depth = 0; depth < 64; ++depth) {
    least = std::min(least, read_bound(group / "memory.max"));
    if (group == top || group == group.parent_path()) break;
    group = group.parent_path();
  }
  return least;
}

double available_memory(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string key, unit;
  double kilobytes = 0.0;
  while (in >> key >> kilobytes) {
    if (key == "MemAvailable:") return kilobytes * 1024.0;
    std::getline(in, unit);
  }
  return kUnbounded;
}

}  // namespace

MemoryLimits memory_limits(const std::filesystem::path& root) {
  rlimit address_space{};
  const bool known = getrlimit(RLIMIT_AS, &address_space) == 0;
  const bool bounded = known && address_space.rlim_cur != RLIM_INFINITY;
  return {.control_group = control_group_limit(root),
          .address_space = bounded ? static_cast<double>(address_space.rlim_cur) : kUnbounded,
          .available = available_memory(root / "proc/meminfo")};
}

double memory_budget(double asked, const MemoryLimits& limits) {
  return std::min({asked > 0.0 ? asked : kUnbounded, limits.control_group, limits.address_space,
                   0.8 * limits.available});
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0;
}

}  // namespace floe::numeric
