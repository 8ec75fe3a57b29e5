#pragma once

#include <floe/numeric/types.hpp>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

namespace floe::fmm::multipole {

/// Numbers on a cache-line boundary, zero at first (by the operating system, where they are many).
template <class Real>
class AlignedArray {
 public:
  AlignedArray() = default;
  explicit AlignedArray(Index size) : size_(size) {
    const std::size_t bytes = static_cast<std::size_t>(size) * sizeof(Real);
    std::size_t space = bytes + kLine;
    memory_.reset(std::calloc(space, 1));
    if (!memory_) throw std::bad_alloc();
    void* begin = memory_.get();
    data_ = static_cast<Real*>(std::align(kLine, bytes, begin, space));
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
