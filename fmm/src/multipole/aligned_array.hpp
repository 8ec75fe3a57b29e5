#pragma once

#include <floe/numeric/types.hpp>

#include <algorithm>
#include <memory>
#include <new>

namespace floe::fmm::multipole {

/// Numbers on a cache-line boundary, zero at first.
template <class Real>
class AlignedArray {
 public:
  AlignedArray() = default;
  explicit AlignedArray(Index size)
      : data_(static_cast<Real*>(::operator new[](bytes(size), kLine))), size_(size) {
    std::fill_n(data_.get(), size, Real(0));
  }

  Real* data() { return data_.get(); }
  const Real* data() const { return data_.get(); }
  Index size() const { return size_; }

 private:
  static constexpr std::align_val_t kLine{64};
  static std::size_t bytes(Index size) { return static_cast<std::size_t>(size) * sizeof(Real); }
  struct Release {
    void operator()(Real* data) const { ::operator delete[](data, kLine); }
  };

  std::unique_ptr<Real[], Release> data_;
  Index size_ = 0;
};

}  // namespace floe::fmm::multipole
