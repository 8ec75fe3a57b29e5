#include "bem/offset_kernels.hpp"

#include "bem/far_rules.hpp"
#include "bem/near_rules.hpp"
#include "bem/quadrature_points.hpp"

#include <array>
#include <vector>

namespace floe::bem {
namespace {

constexpr int kBatchPoints = 1024;  // distances evaluated at once: 24 kB, stays in the L1 cache

// Targets of one row of offsets that follow one another and take the same rule
class TargetRun {
 public:
  TargetRun(const FarRules& rules, const mesh::Connectivity& nodes, const green::GreenTable& green,
            OffsetKernels& kernels)
      : rules_(rules), nodes_(nodes), green_(green), kernels_(kernels) {}

  void add(const Point2& target, Index column, int tier) {
    const int size = FarRules::size(tier);
    if (tier != tier_ || (count_ + 1) * size > kBatchPoints) flush();
    if (tier != tier_) rules_.fill_points(tier, 0, x_.data(), y_.data(), area_.data());
    tier_ = tier;
    if (count_ == 0) first_ = column;
    fill_distances(target, x_.data(), y_.data(), static_cast<std::size_t>(size),
                   distance_.data() + count_ * size);
    ++count_;
  }

  void flush() {
    if (count_ == 0) return;
    const auto size = static_cast<std::size_t>(FarRules::size(tier_));
    const std::size_t points = static_cast<std::size_t>(count_) * size;
    green_.evaluate({distance_.data(), points}, {value_.data(), points});
    for (int k = 0; k < count_; ++k) {
      std::array<Complex, 8> sum;
      Complex* const value = value_.data() + static_cast<std::size_t>(k) * size;
      scale_values(area_.data(), size, value);
      sum_weighted(rules_.shape(tier_), value, size, sum.data());
      for (int m = 0; m < 8; ++m) kernels_(nodes_(m, 0), first_ + k) = sum[m];
    }
    count_ = 0;
  }

 private:
  const FarRules& rules_;            // view
  const mesh::Connectivity& nodes_;  // view
  const green::GreenTable& green_;   // view
  OffsetKernels& kernels_;           // view
  int tier_ = -1, count_ = 0;
  Index first_ = 0;
  std::array<double, FarRules::size(FarRules::kTiers - 1)> x_, y_, area_;  // of the present tier
  std::array<double, kBatchPoints> distance_;
  std::array<Complex, kBatchPoints> value_;
};

// The tier of ElementIntegrals::point_row for this target
int tier_of(const Point2& target, const FarRules& rules, const mesh::Q8Mesh& element, int wave) {
  const double half_edge = rules.half_edge(0);
  double gap = (rules.centre(0) - target).norm() - rules.radius(0);
  if (gap < 4.0 * half_edge) gap = distance_to_element(target, element.element_nodes(0));
  return std::max(rules.tier_for_gap(gap, half_edge), wave);
}

}  // namespace

OffsetKernels offset_kernels(const mesh::Q8Mesh& element, double tolerance, const OffsetGrid& grid,
                             const green::GreenTable& green) {
  const FarRules rules(element, tolerance);
  const ElementIntegrals integrals(element, {.tolerance = tolerance});
  const int wave = rules.tier_for_wave(green.exact().wavenumber(), rules.half_edge(0));
  OffsetKernels kernels(8, grid.nx * grid.ny);
#pragma omp parallel
  {
    TargetRun run(rules, element.elements(), green, kernels);
    VecXcd near(8);
#pragma omp for schedule(dynamic, 1)
    for (Index j = 0; j < grid.ny; ++j) {
      for (Index i = 0; i < grid.nx; ++i) {
        const Point2 target((static_cast<double>(i) + (grid.half_x ? 0.5 : 0.0)) * grid.step_x,
                            (static_cast<double>(j) + (grid.half_y ? 0.5 : 0.0)) * grid.step_y);
        const Index column = i + grid.nx * j;
        const int tier = tier_of(target, rules, element, wave);
        if (tier < FarRules::kTooNear) {
          run.add(target, column, tier);
        } else {
          run.flush();
          integrals.point_row(target, green, near);
          kernels.col(column) = near;
        }
      }
      run.flush();
    }
  }
  return kernels;
}

}  // namespace floe::bem
