#pragma once

#include <string>

namespace floe::test {

/// Whether the address sanitizer is in the program: then no other allocations can be put before its
/// own, address space cannot be limited, and all takes ten times as long.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// The environment with which a program loads `library` before its own ones. The sanitizer's
/// library wants to be the first of them; what stands before it here takes no memory.
inline std::string preloading(const std::string& library) {
  const std::string lenient = kSanitized ? "ASAN_OPTIONS=verify_asan_link_order=0 " : "";
  return lenient + "LD_PRELOAD='" + library + "' ";
}

}  // namespace floe::test
