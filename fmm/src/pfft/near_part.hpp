#pragma once

#include "pfft/precorrection.hpp"
#include "pfft/sorted_columns.hpp"

#include <floe/fmm/radial_kernel.hpp>

namespace floe::fmm::pfft {

/// The near matrix of (F.6), Re(G - far value), for the near pairs of a plan: the grid carries the
/// smooth Im G of near pairs as well as of others. Rows of sorted targets; a row's columns are the
/// near ranges of its cell, so that no index is stored.
template <class Real>
class NearPart {
 public:
  NearPart(const Geometry& geometry, const Precorrection<Real>& grid_values,
           const RadialKernel& kernel);

  /// potentials += near matrix · charges, every column.
  void multiply_add(const Geometry& geometry, const SortedColumns<Real>& charges,
                    const SortedColumns<Real>& potentials) const;

  double memory() const { return sizeof(Real) * static_cast<double>(value_.size()); }

 private:
  template <class Visit>
  void for_rows(const Geometry& geometry, const Visit& visit) const;

  std::vector<Real> value_;
};

}  // namespace floe::fmm::pfft
