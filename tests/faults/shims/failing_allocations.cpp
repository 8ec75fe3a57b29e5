#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

// Preloaded into the program: the allocation of number FLOE_FAIL_ALLOCATION fails, all others
// succeed. Without the variable nothing fails.
extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

static std::atomic<long> count{0};
static std::atomic<long> chosen{-1};

static bool must_fail() {
  if (chosen.load() < 0) {
    const char* text = std::getenv("FLOE_FAIL_ALLOCATION");
    chosen = text ? std::atol(text) : 0;
  }
  if (++count != chosen.load()) return false;
  errno = ENOMEM;
  return true;
}

void* malloc(std::size_t size) { return must_fail() ? nullptr : __libc_malloc(size); }

void* calloc(std::size_t number, std::size_t size) {
  return must_fail() ? nullptr : __libc_calloc(number, size);
}

void* realloc(void* pointer, std::size_t size) {
  return must_fail() ? nullptr : __libc_realloc(pointer, size);
}

void* memalign(std::size_t alignment, std::size_t size) {
  return must_fail() ? nullptr : __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }

int posix_memalign(void** pointer, std::size_t alignment, std::size_t size) {
  *pointer = memalign(alignment, size);
  return *pointer ? 0 : ENOMEM;
}

}  // extern "C"
