#pragma once

#include "pfft/grid.hpp"

namespace floe::fmm::pfft {

/// Estimates near pairs of many designs without sorting the points anew for each: sources are
/// counted once in fine boxes, and sampled targets ask for rectangles.
class NearCounter {
 public:
  NearCounter(const Points2& sources, const Points2& targets);

  struct Lengths {
    double pairs;   ///< near sources
    double stored;  ///< the same, filled up to whole vectors
  };
  /// Mean over targets.
  Lengths near_lengths(const Grid& grid, const NearShape& shape, Precision precision) const;

 private:
  double count_below(double x, double y) const;

  Point2 low_;
  double boxes_a_metre_;
  Index nx_, ny_;
  std::vector<float> below_;  // sources in boxes (< i, < j), (nx + 1)·(ny + 1)
  Points2 sample_;            // of the targets
};

}  // namespace floe::fmm::pfft
