#pragma once

#include <floe/fmm/kernel_sum.hpp>
#include <floe/fmm/pfft_plan.hpp>

#include <memory>

namespace floe::fmm {

namespace pfft {
class Engine;
}

/// Pre-corrected FFT (F.4)–(F.6): charges are projected onto a regular grid, the grid is convolved
/// with the kernel by FFT, potentials are interpolated, and for near pairs the grid's value is
/// replaced by the kernel itself. For points that fill much of their bounding rectangle.
/// O(N + A log A) work for a grid of A points. The smooth Im G of near pairs stays with the grid:
/// of a near pair `far_apply` holds Im G to the tolerance, Im G(0) where points coincide, and
/// `apply` corrects the real part only. Works in single precision from a tolerance of 1e-6 on.
class PfftSum final : public KernelSum {
 public:
  /// Is the near part wanted too, or does an operator bring its own near matrix?
  enum class Parts { all, far_only };

  /// Evaluates the kernel on the grid and for near pairs; does not keep it. Throws InputError when
  /// its wavenumber exceeds the plan's or its wave coefficient is not imaginary.
  PfftSum(std::shared_ptr<const PfftPlan> plan, const RadialKernel& kernel,
          Parts parts = Parts::all);
  ~PfftSum() override;

  Index source_count() const override;
  Index target_count() const override;
  /// Throws InputError for a sum made with Parts::far_only.
  void apply(const Eigen::Ref<const MatXcd>& charges, Eigen::Ref<MatXcd> potentials) const override;
  void far_apply(const Eigen::Ref<const MatXcd>& charges,
                 Eigen::Ref<MatXcd> potentials) const override;
  std::vector<Index> near_sources(Index target) const override;
  void far_values(Index target, std::span<const Index> sources,
                  std::span<Complex> values) const override;
  double memory() const override;  ///< without the plan's [byte]

  const PfftPlan& plan() const { return *plan_; }

 private:
  std::shared_ptr<const PfftPlan> plan_;
  std::unique_ptr<const pfft::Engine> engine_;
};

}  // namespace floe::fmm
