#pragma once

#include "bem/near_rows.hpp"

#include <vector>

namespace floe::bem {

/// The near matrix C of (F.2): exact integrals over near elements minus what the source points give
/// for them. It is real: Im G is smooth, and its integral by the source points is as good near as
/// far. Values in float or double; rows as NearPattern has them.
template <class Real>
class NearMatrix {
 public:
  /// Assembled in parallel, same bits for any number of threads. By moments where these, in sampled
  /// rows, agree with the integrals to a third of `tolerance`; else every element is integrated,
  /// which is slower: water much shallower than an element is long, a few elements a wavelength.
  NearMatrix(const NearSetup& setup, double tolerance);

  /// y(targets) += scale · C x, all columns. The pattern is the one that it was made with.
  void multiply_add(const NearPattern& pattern, const Eigen::Ref<const MatXcd>& x, double scale,
                    Eigen::Ref<MatXcd> y) const;

  double memory() const { return sizeof(Real) * static_cast<double>(value_.size()); }

 private:
  std::vector<Real> value_;  // of each entry
};

}  // namespace floe::bem
