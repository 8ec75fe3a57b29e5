#include "column_fft.hpp"

#include <floe/fmm/fft_plan.hpp>
#include <floe/numeric/error.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace floe::fmm {
namespace {

using Direction = ColumnFft::Direction;

// Rounding of an FFT grows like ε·log n: 1e-14 leaves a factor of five or more
constexpr double kRounding = 1e-14;

Complex element(const double* data, Index n, Index lane) {
  const double* const at = data + n * ColumnFft::kElement + lane;
  return {at[0], at[ColumnFft::kLanes]};
}

std::vector<Complex> dft(const double* data, Index length, Index lane, double sign) {
  std::vector<Complex> sum(static_cast<std::size_t>(length));
  for (Index m = 0; m < length; ++m)
    for (Index n = 0; n < length; ++n)
      sum[m] += element(data, n, lane) * std::polar(1.0, -sign * 2.0 * std::numbers::pi *
                                                             static_cast<double>(m * n % length) /
                                                             static_cast<double>(length));
  return sum;
}

void expect_transforms(Index length, Direction direction) {
  const ColumnFft fft(length);
  const FftBuffer data(length * ColumnFft::kLanes), scratch(length * ColumnFft::kLanes);
  double* const values = reinterpret_cast<double*>(data.data());
  double* const other = reinterpret_cast<double*>(scratch.data());
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (Index i = 0; i < length * ColumnFft::kElement; ++i) values[i] = uniform(engine);

  std::vector<std::vector<Complex>> expected;
  for (Index lane = 0; lane < ColumnFft::kLanes; ++lane)
    expected.push_back(dft(values, length, lane, direction == Direction::forward ? 1.0 : -1.0));
  fft.execute(direction, values, other);
  const double* const result = fft.swaps() ? other : values;
  double error = 0.0, norm = 0.0;
  for (Index lane = 0; lane < ColumnFft::kLanes; ++lane)
    for (Index m = 0; m < length; ++m) {
      error += std::norm(element(result, m, lane) - expected[lane][m]);
      norm += std::norm(expected[lane][m]);
    }
  EXPECT_LE(std::sqrt(error / norm), kRounding) << "length " << length;
}

TEST(twin_ColumnFft, EqualsTheFourierSumForEveryRadix) {
  for (const Index length : {1, 2, 3, 4, 5, 7, 8, 12, 30, 49, 63, 64, 75, 210, 280, 540})
    for (const Direction direction : {Direction::forward, Direction::backward})
      expect_transforms(length, direction);
}

TEST(ColumnFft, RejectsLengthsWithOtherPrimeFactors) {
  for (const Index length : {-4, 0, 11, 26}) EXPECT_THROW(ColumnFft{length}, InputError);
}

}  // namespace
}  // namespace floe::fmm
