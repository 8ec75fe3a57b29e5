#pragma once

#include <floe/numeric/types.hpp>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

namespace floe::fmm::multipole {

/// Numbers on a cache-line boundary, zero at first (by the operating system, where they are many).
template <class Real>
class AlignedArray {
 public:
  AlignedArray() = default;
  explicit AlignedArray(Index size)
      : memory_(std::calloc(static_cast<std::size_t>(size) * sizeof(Real) + kLine, 1)),
        size_(size) {
    if (!memory_) throw std::bad_alloc();
    const auto address = reinterpret_cast<std::uintptr_t>(memory_.get());
    data_ = reinterpret_cast<Real*>((address + kLine - 1) / kLine * kLine);
  }

  Real* data() { return data_; }
  const Real* data() const { return data_; }
  Index size() const { return size_; }

 private:
  static constexpr std::size_t kLine = 64;
  struct Release {
    void operator()(void* memory) const { std::free(memory); }
  };

  std::unique_ptr<void, Release> memory_;
  Real* data_ = nullptr;
  Index size_ = 0;
};

}  // namespace floe::fmm::multipole
