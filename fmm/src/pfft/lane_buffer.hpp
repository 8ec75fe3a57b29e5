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

/// Values on a grid row by row: real parts, `stride` later imaginary parts, 2·stride later the next
/// row, with room for a stencil's weights behind the end of each.
template <class Real>
struct GridData {
  GridData(Index nx, Index ny) : stride(row_stride(nx)), size(2 * stride * ny), values(size) {}
  Real* row(Index j) const { return values.data() + 2 * stride * j; }
  Index stride, size;
  LaneBuffer<Real> values;

 private:
  // NOTE: addresses that differ by nearly a multiple of 4096 byte are taken for the same when a
  // load follows a store, and wait
  static Index row_stride(Index nx) {
    constexpr Index kPage = 4096 / static_cast<Index>(sizeof(Real));
    const Index least = whole_lanes<Real>(nx) + 8, over = (least + 64) % kPage;
    return over < 128 ? least + 128 - over : least;
  }
};

}  // namespace floe::fmm::pfft
