#include "targets.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

// One program a target, FLOE_FUZZ_TARGET its name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const floe::fuzz::Target* const target = [] {
    for (const floe::fuzz::Target& candidate : floe::fuzz::targets())
      if (candidate.name == FLOE_FUZZ_TARGET) return &candidate;
    std::abort();
  }();
  floe::fuzz::run(*target, {reinterpret_cast<const char*>(data), size});
  return 0;
}
