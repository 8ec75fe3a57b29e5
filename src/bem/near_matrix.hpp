#pragma once

#include "bem/near_pattern.hpp"
#include "bem/source_rule.hpp"

#include <floe/bem/element_integrals.hpp>
#include <floe/fmm/kernel_sum.hpp>
#include <floe/green/green_table.hpp>

#include <memory>
#include <vector>

namespace floe::bem {

/// The near matrix C of (F.2): exact integrals over near elements minus what the engine and the
/// source points give for them. Values in float or double; rows as NearPattern has them.
template <class Real>
class NearMatrix {
 public:
  /// Assembled in parallel, same bits for any number of threads; equal pairs are integrated once.
  NearMatrix(const NearPattern& pattern, const ElementIntegrals& integrals, const SourceRule& rule,
             const fmm::KernelSum& sum, const green::GreenTable& green);

  /// y(targets) += scale · C x, all columns. The pattern is the one that it was made with.
  void multiply_add(const NearPattern& pattern, const Eigen::Ref<const MatXcd>& x, double scale,
                    Eigen::Ref<MatXcd> y) const;

  double memory() const { return sizeof(Real) * static_cast<double>(value_.size()); }

 private:
  std::vector<Real> value_;  // re, im of each entry
};

}  // namespace floe::bem
