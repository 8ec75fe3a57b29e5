#pragma once

#include "multipole/aligned_array.hpp"
#include "multipole/geometry.hpp"
#include "multipole/products.hpp"

#include <floe/fmm/radial_kernel.hpp>

namespace floe::fmm::multipole {

/// Re G of adjacent leaves: one matrix a target leaf, its columns the sources of all its
/// neighbours; 0 for coincident points. Stored, or evaluated again in every call.
template <class Real>
class NearRows {
 public:
  NearRows(const Geometry& geometry, const RadialKernel& kernel, bool stored);

  Index groups() const { return static_cast<Index>(groups_.size()); }
  /// Adds the neighbours of the group's targets; charges and potentials in the tree's order, real
  /// and imaginary parts `stride` apart, columns two strides apart.
  void add(Index group, const Real* charges, Index charge_stride, Index columns, Real* potentials,
           Index potential_stride) const;
  double memory() const {
    return static_cast<double>(sizeof(Real)) * static_cast<double>(values_.size());
  }

 private:
  Index length(Index group) const;  // of a row, padded
  void fill(Index group, Real* rows) const;

  const Geometry& geometry_;    // view
  const RadialKernel& kernel_;  // view
  std::vector<std::pair<Index, Index>> groups_;
  std::vector<Index> start_;
  AlignedArray<Real> values_;
};

}  // namespace floe::fmm::multipole
