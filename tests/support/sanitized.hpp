#pragma once

namespace floe::test {

/// Whether the address sanitizer is in the program: then nothing can be put before its own
/// allocations, address space cannot be limited, and all takes ten times as long.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace floe::test
