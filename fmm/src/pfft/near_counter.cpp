#include "pfft/near_counter.hpp"

#include <algorithm>
#include <cmath>

namespace floe::fmm::pfft {
namespace {

constexpr Index kSamples = 2000;
constexpr double kBoxesAPoint = 6.0;

}  // namespace

NearCounter::NearCounter(const Points2& sources, const Points2& targets)
    : low_(sources.rowwise().minCoeff()) {
  // Boxes: square, some a point
  const Point2 size = (sources.rowwise().maxCoeff() - low_).cwiseMax(1e-300);
  const double wanted = kBoxesAPoint * static_cast<double>(sources.cols()) + 100.0;
  const double width = std::max(std::sqrt(size.x() * size.y() / wanted), size.maxCoeff() / wanted);
  boxes_a_metre_ = 1.0 / width;
  nx_ = static_cast<Index>(size.x() * boxes_a_metre_) + 1;
  ny_ = static_cast<Index>(size.y() * boxes_a_metre_) + 1;

  // Count, then sum over boxes below. NOTE: float rounds counts beyond 2^24, which is enough here
  below_.assign(static_cast<std::size_t>((nx_ + 1) * (ny_ + 1)), 0.0f);
  for (Index i = 0; i < sources.cols(); ++i) {
    const auto bx =
        std::min(nx_ - 1, static_cast<Index>((sources(0, i) - low_.x()) * boxes_a_metre_));
    const auto by =
        std::min(ny_ - 1, static_cast<Index>((sources(1, i) - low_.y()) * boxes_a_metre_));
    below_[bx + 1 + (nx_ + 1) * (by + 1)] += 1.0f;
  }
  for (Index j = 1; j <= ny_; ++j) {
    double row = 0.0;
    for (Index i = 1; i <= nx_; ++i) {
      row += below_[i + (nx_ + 1) * j];
      below_[i + (nx_ + 1) * j] = static_cast<float>(row + below_[i + (nx_ + 1) * (j - 1)]);
    }
  }

  const Index samples = std::min(kSamples, targets.cols());
  sample_.resize(2, samples);
  for (Index s = 0; s < samples; ++s) sample_.col(s) = targets.col(targets.cols() * s / samples);
}

// Sources below and left of a point, as if those of a box were spread over it
double NearCounter::count_below(double x, double y) const {
  const double bx = std::clamp((x - low_.x()) * boxes_a_metre_, 0.0, static_cast<double>(nx_));
  const double by = std::clamp((y - low_.y()) * boxes_a_metre_, 0.0, static_cast<double>(ny_));
  const Index i = std::min(nx_ - 1, static_cast<Index>(bx));
  const Index j = std::min(ny_ - 1, static_cast<Index>(by));
  const double fx = bx - static_cast<double>(i), fy = by - static_cast<double>(j);
  const float* const corner = below_.data() + i + (nx_ + 1) * j;
  return (1.0 - fy) * ((1.0 - fx) * corner[0] + fx * corner[1]) +
         fy * ((1.0 - fx) * corner[nx_ + 1] + fx * corner[nx_ + 2]);
}

NearCounter::Lengths NearCounter::near_lengths(const Grid& grid, const NearShape& shape,
                                               Precision precision) const {
  Lengths sum{0.0, 0.0};
  const double fill = 0.5 * static_cast<double>(padded_range(1, precision) - 1);
  const double first = 0.5 * grid.stencil - 1.0;  // of the positions within a stencil
  for (Index s = 0; s < sample_.cols(); ++s) {
    // Corner of the target's cell, in spacings from the grid's origin
    const Point2 position = grid.locate(sample_.col(s));
    const double cx = static_cast<double>(stencil_begin(position.x(), grid.stencil)) + first;
    const double cy = static_cast<double>(stencil_begin(position.y(), grid.stencil)) + first;
    for (int dy = -shape.radius; dy <= shape.radius; ++dy) {
      const int half = shape.half_width[static_cast<std::size_t>(std::abs(dy))];
      double x0 = grid.origin.x() + grid.spacing * (cx - half);
      double x1 = grid.origin.x() + grid.spacing * (cx + half + 1);
      double y0 = grid.origin.y() + grid.spacing * (cy + dy);
      double y1 = y0 + grid.spacing;
      if (grid.exchanged) {
        std::swap(x0, y0);
        std::swap(x1, y1);
      }
      const double count =
          count_below(x1, y1) - count_below(x0, y1) - count_below(x1, y0) + count_below(x0, y0);
      sum.pairs += count;
      sum.stored += count + std::min(count, 1.0) * fill;
    }
  }
  const auto samples = static_cast<double>(sample_.cols());
  return {sum.pairs / samples, sum.stored / samples};
}

}  // namespace floe::fmm::pfft
