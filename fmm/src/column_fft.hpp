#pragma once

#include <floe/numeric/types.hpp>

#include <vector>

namespace floe::fmm {

/// Complex transforms of kLanes columns at once, unnormalised, of lengths 2^a 3^b 5^c 7^d. Element
/// n of all columns is kLanes real parts, then kLanes imaginary parts, so that every operation is
/// one on whole vectors. Same bits in every run. Execution is const and thread-safe.
class ColumnFft {
 public:
  static constexpr Index kLanes = 4;
  static constexpr Index kElement = 2 * kLanes;  ///< doubles
  enum class Direction { forward, backward };

  /// Throws InputError on other lengths.
  explicit ColumnFft(Index length);

  /// Transforms `data` (length·kElement doubles, 32-byte aligned); `scratch` is as large. The
  /// result lies in `scratch` where swaps() says so, else in `data`; the other is overwritten.
  void execute(Direction direction, double* data, double* scratch) const;
  bool swaps() const { return stages_.size() % 2 == 1; }

 private:
  /// One step of Stockham's algorithm: DFTs of `radix` elements that lie a radix-th of the length
  /// apart.
  struct Stage {
    int radix;
    Index groups, stride;
    std::size_t twiddle;  ///< first of its groups·(radix - 1) factors
  };

  std::vector<Stage> stages_;
  std::vector<double> twiddle_;  ///< cos, sin of positive angles
};

}  // namespace floe::fmm
