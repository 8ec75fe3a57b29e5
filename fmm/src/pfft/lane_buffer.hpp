#pragma once

#include "pfft/lanes.hpp"

#include <algorithm>
#include <memory>
#include <new>

namespace floe::fmm::pfft {

/// Numbers on a cache-line boundary.
template <class Real>
class LaneBuffer {
 public:
  explicit LaneBuffer(Index count)
      : data_(static_cast<Real*>(::operator new (sizeof(Real) * static_cast<std::size_t>(count),
                                                 std::align_val_t{64}))) {}
  static LaneBuffer zeros(Index count) {
    LaneBuffer buffer(count);
    std::fill_n(buffer.data(), count, Real(0));
    return buffer;
  }
  Real* data() const { return data_.get(); }

 private:
  struct Free {
    void operator()(Real* data) const { ::operator delete (data, std::align_val_t{64}); }
  };
  std::unique_ptr<Real, Free> data_;
};

/// Real and imaginary part of values on a grid, each row by row, with room for a stencil's
/// weights behind the end of a row.
template <class Real>
struct GridData {
  GridData(Index nx, Index ny)
      : stride(whole_lanes<Real>(nx) + 8), size(stride * ny), re(size), im(size) {}
  Index stride, size;
  LaneBuffer<Real> re, im;
};

}  // namespace floe::fmm::pfft
