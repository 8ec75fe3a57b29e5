#pragma once

/// Compiles a leaf function for several instruction sets and picks one at load time, so that the
/// same binary runs on any x86-64. Use it on plain loops without OpenMP regions.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define FLOE_SIMD_CLONES \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define FLOE_SIMD_CLONES
#endif

namespace floe::numeric {

/// Whether vectors of 64 bytes are one register here. Where they are not, loops that hold many of
/// them run out of registers and take several times as long as with vectors of 32 bytes.
inline bool has_wide_vectors() {
#if defined(__x86_64__) && defined(__GNUC__)
  static const bool wide = __builtin_cpu_supports("avx512vl");
  return wide;
#else
  return false;
#endif
}

}  // namespace floe::numeric
