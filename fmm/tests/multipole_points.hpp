#pragma once

#include <floe/fmm/radial_kernel.hpp>
#include <floe/numeric/types.hpp>

#include <math.h>  // j0 and y0, POSIX

#include <algorithm>
#include <cmath>
#include <random>

/// Points, charges and a kernel for the tests of the multipole sum.
namespace floe::fmm::test {

/// 2/R e^{-R} + c H0⁽¹⁾(kR): singular, with a real remainder that decays, like the water's.
class WaterLikeKernel final : public RadialKernel {
 public:
  explicit WaterLikeKernel(double wavenumber) : wavenumber_(wavenumber) {}

  void evaluate(std::span<const double> distance, std::span<Complex> value) const override {
    for (std::size_t i = 0; i < distance.size(); ++i) {
      const double kR = wavenumber_ * distance[i];
      value[i] = 2.0 / distance[i] * std::exp(-distance[i]) +
                 wave().coefficient * Complex(::j0(kR), ::y0(kR));
    }
  }
  WaveTerm wave() const override { return {wavenumber_, Complex(0.0, 6.0 * wavenumber_)}; }

 private:
  double wavenumber_;
};

/// Points in the unit square.
inline Points2 uniform_points(Index count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  return Points2::NullaryExpr(2, count, [&] { return uniform(random); });
}

/// Points that gather at the origin over ten octaves, as many in each.
inline Points2 clustered_points(Index count, unsigned seed) {
  Points2 points = uniform_points(count, seed);
  for (Index i = 0; i < count; ++i)
    points.col(i) *= std::exp2(-10.0 * static_cast<double>(i) / static_cast<double>(count));
  return points;
}

/// Two small groups at opposite corners.
inline Points2 far_groups(Index count, unsigned seed) {
  Points2 points = 0.05 * uniform_points(count, seed);
  points.rightCols(count / 2).array() += 0.95;
  return points;
}

inline MatXcd random_charges(Index count, Index columns, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  return MatXcd::NullaryExpr(count, columns,
                             [&] { return Complex(normal(random), normal(random)); });
}

}  // namespace floe::fmm::test
