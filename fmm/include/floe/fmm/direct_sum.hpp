#pragma once

#include <floe/fmm/kernel_sum.hpp>

namespace floe::fmm {

/// All pairs, one by one: the truth in every test. O(targets · sources) kernel values, evaluated
/// once for all columns of a block. Keeps a view of the kernel, which must outlive it.
class DirectSum final : public KernelSum {
 public:
  /// Points are 2 × count. Throws InputError when a coordinate is not finite.
  DirectSum(Points2 sources, Points2 targets, const RadialKernel& kernel);

  Index source_count() const override { return sources_.cols(); }
  Index target_count() const override { return targets_.cols(); }
  void apply(const Eigen::Ref<const MatXcd>& charges, Eigen::Ref<MatXcd> potentials) const override;

  /// The far part is nothing, every source is near.
  void far_apply(const Eigen::Ref<const MatXcd>& charges,
                 Eigen::Ref<MatXcd> potentials) const override;
  std::vector<Index> near_sources(Index target) const override;
  void far_values(Index target, std::span<const Index> sources,
                  std::span<Complex> values) const override;
  double memory() const override;

  /// The potential at one target, columns wide: what sampled_error asks for.
  Eigen::RowVectorXcd potential_at(Index target, const Eigen::Ref<const MatXcd>& charges) const;

 private:
  Points2 sources_, targets_;
  const RadialKernel& kernel_;  // view
};

}  // namespace floe::fmm
