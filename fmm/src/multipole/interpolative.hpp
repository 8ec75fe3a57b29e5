#pragma once

#include <floe/numeric/types.hpp>

#include <vector>

namespace floe::fmm::multipole {

/// A ≈ A(:, columns) · interpolation: the columns that matter and what the others are made of.
struct Interpolative {
  std::vector<Index> columns;
  MatXd interpolation;  ///< columns chosen × all columns; the identity on the chosen ones
};

/// Interpolative decomposition by pivoted Gram–Schmidt, stopped where every column of the rest is
/// below `tolerance` times the largest column of A. O(rows · columns · rank).
Interpolative interpolative_decomposition(MatXd a, double tolerance);

}  // namespace floe::fmm::multipole
