#pragma once

#include "pfft/precorrection.hpp"

#include <floe/fmm/radial_kernel.hpp>

namespace floe::fmm::pfft {

inline constexpr Index kLanes = 4;  // partial sums of a row, whatever the instruction set

/// Length of a stored range of near values: the lanes are filled with zeros.
inline Index padded_range(Index count) { return (count + kLanes - 1) / kLanes * kLanes; }

/// The near matrix of (F.6), G - far value, for the near pairs of a plan: rows of sorted targets;
/// a row's columns are the near ranges of its cell, so that no index is stored. `Real` is the
/// precision of the stored values: 8 or 16 bytes a pair. Sums are in double.
template <class Real>
class NearPart {
 public:
  NearPart(const Geometry& geometry, const Precorrection& grid_values, const RadialKernel& kernel);

  /// potentials (original order) += near matrix · charges (original order), every column.
  void multiply_add(const Geometry& geometry, const Eigen::Ref<const MatXcd>& charges,
                    Eigen::Ref<MatXcd> potentials) const;

  double memory() const { return sizeof(Real) * static_cast<double>(value_.size()); }

 private:
  std::vector<Real> value_;  // kLanes real parts, kLanes imaginary parts, and so on
};

}  // namespace floe::fmm::pfft
