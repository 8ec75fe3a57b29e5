#pragma once

#include <floe/green/green_function.hpp>
#include <floe/numeric/types.hpp>

#include <array>
#include <span>

namespace floe::bem {

/// What of G is not smooth at R = 0 (F.22): 1/R, log R, R and R² log R, with coefficients that
/// depend on ν alone, at any depth. What is left is smooth to the order R³.
struct SingularFunctions {
  static constexpr int kCount = 4;

  /// value[i] = 1/R + i log R, value[n + i] = R + i R² log R of the n distances [m].
  static void evaluate(std::span<const double> distance, Complex* value);

  /// Factors of the four functions in G.
  static std::array<double, kCount> coefficients(double nu);

  /// Limit of G minus the four functions for R → 0 [1/m]; relative error 1e-7.
  static Complex rest_at_zero(const green::GreenFunction& green);
};

}  // namespace floe::bem
