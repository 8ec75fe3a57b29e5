#pragma once

#include <atomic>
#include <cstddef>

/// Counts what a program takes from the heap, whoever asks for it. Included once a program.
namespace floe::bench {

inline std::atomic<std::size_t> allocated_so_far{0};

/// Bytes asked for so far; what was given back counts too.
inline double allocated_bytes() { return static_cast<double>(allocated_so_far.load()); }

}  // namespace floe::bench

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  floe::bench::allocated_so_far += size;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  floe::bench::allocated_so_far += count * size;
  return __libc_calloc(count, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  floe::bench::allocated_so_far += size;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  floe::bench::allocated_so_far += size;
  *block = __libc_memalign(alignment, size);
  return *block == nullptr ? 12 : 0;
}
}
#endif
