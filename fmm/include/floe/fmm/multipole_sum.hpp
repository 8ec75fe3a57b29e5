#pragma once

#include <floe/fmm/kernel_sum.hpp>

#include <memory>

namespace floe::fmm {

namespace multipole {
struct Geometry;
class Engine;
}  // namespace multipole

struct MultipoleOptions {
  /// Points of a leaf box that the tree aims at; they lie between a half and twice of it. More of
  /// them shift work from translations to neighbours.
  Index leaf_size = 20;
};

/// The part of a multipole sum that knows no kernel: the quadtree over sources and targets and its
/// interaction lists. Built once for a whole frequency sweep. O(N log N) time, O(N) memory.
class MultipolePlan {
 public:
  /// Points are 2 × count [m]. Throws InputError when a coordinate is not finite or the leaf size
  /// is not positive.
  MultipolePlan(const Points2& sources, const Points2& targets,
                const MultipoleOptions& options = {});
  ~MultipolePlan();

  Index source_count() const;
  Index target_count() const;
  /// Largest distance at which a sum on this plan evaluates its kernel [m]: let a table go so far.
  double reach() const;
  /// Those of every sum on this plan.
  std::vector<Index> near_sources(Index target) const;
  double memory() const;  ///< [byte]
  const multipole::Geometry& geometry() const { return *geometry_; }

 private:
  std::unique_ptr<const multipole::Geometry> geometry_;
};

/// What `apply` adds neighbours from.
enum class NearSums {
  kStored,    ///< matrices of Re G, built by the constructor: fast, some 9 · leaf size numbers a
              ///< target
  kEvaluated  ///< the kernel, again in every call: for a few calls, or when only far_apply is used
};

/// Fast multipole sum of (F.1), kernel-independent (F.11)–(F.13): a box is seen from afar through r
/// functions, the same for all boxes of a level, that carry the whole of G = c H0(kR) + F(R). All
/// translations are real matrices: Re G goes over interaction lists, the smooth
/// Im G = |c| J0(kR) over all pairs at once at the top of the tree.
///
/// Accuracy: ‖u - u*‖₂/‖u*‖₂ ≤ tolerance, from 1e-2 to 1e-9. Cost: O(N) where boxes are small
/// against the wavelength, ranks grow with the width of a box in wavelengths above. Near pairs are
/// those of adjacent leaf boxes; of them far_apply holds i Im G, which is c for coincident points,
/// and nothing of Re G. Works in single precision inside when the tolerance allows.
class MultipoleSum final : public KernelSum {
 public:
  /// The kernel is a view and must outlive the sum. Throws InputError unless 1e-10 ≤ tolerance < 1
  /// and c is imaginary.
  MultipoleSum(std::shared_ptr<const MultipolePlan> plan, const RadialKernel& kernel,
               double tolerance, NearSums near = NearSums::kStored);
  ~MultipoleSum() override;

  Index source_count() const override;
  Index target_count() const override;
  void apply(const Eigen::Ref<const MatXcd>& charges, Eigen::Ref<MatXcd> potentials) const override;
  void far_apply(const Eigen::Ref<const MatXcd>& charges,
                 Eigen::Ref<MatXcd> potentials) const override;
  std::vector<Index> near_sources(Index target) const override;
  void far_values(Index target, std::span<const Index> sources,
                  std::span<Complex> values) const override;
  /// Without the plan, which sums may share.
  double memory() const override;

  /// Functions a box on each level, from level 2 of the tree down.
  std::vector<Index> ranks() const;

 private:
  std::shared_ptr<const MultipolePlan> plan_;
  const RadialKernel& kernel_;  // view
  std::unique_ptr<const multipole::Engine> engine_;
};

}  // namespace floe::fmm
