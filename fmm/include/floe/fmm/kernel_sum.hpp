#pragma once

#include <floe/fmm/radial_kernel.hpp>
#include <floe/numeric/types.hpp>

#include <span>
#include <vector>

namespace floe::fmm {

/// The sum that every engine computes, for points in the plane (F.1):
///   u_i = Σ_j G(|x_i - y_j|) q_j   over all pairs with |x_i - y_j| > 0
/// to a relative tolerance ‖u - u*‖₂ / ‖u*‖₂. Charges and potentials are blocks of columns; targets
/// and sources may be the same points or others. Construct = plan, call = execute, execute is
/// const. Same bits for any number of threads, and for a column alone or in a block.
///
/// An engine is a far part, fast and approximate, plus direct sums over near pairs:
///   apply = far_apply + Σ_{j near i} (G(|x_i - y_j|) - far_value(i, j)) q_j
/// The far part stands by itself for callers that know their near pairs better and store one matrix
/// of them, minus what the engine already gave. (The boundary element operator takes the whole, and
/// corrects the few elements around each node.)
class KernelSum {
 public:
  virtual ~KernelSum() = default;

  virtual Index source_count() const = 0;
  virtual Index target_count() const = 0;

  /// potentials (targets × columns) = all pairs' sum of charges (sources × columns).
  virtual void apply(const Eigen::Ref<const MatXcd>& charges,
                     Eigen::Ref<MatXcd> potentials) const = 0;

  /// The far part of the same.
  virtual void far_apply(const Eigen::Ref<const MatXcd>& charges,
                         Eigen::Ref<MatXcd> potentials) const = 0;

  /// Sources near target i, rising. Coincident points are among them.
  virtual std::vector<Index> near_sources(Index target) const = 0;

  /// What far_apply contains of each pair (target, sources[k]) that is near, per unit charge.
  /// Not asked for pairs that are not near: there it is G to the tolerance.
  virtual void far_values(Index target, std::span<const Index> sources,
                          std::span<Complex> values) const = 0;

  /// Memory held [byte].
  virtual double memory() const = 0;
};

}  // namespace floe::fmm
