#include "pfft/lane_convolution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace floe::fmm::pfft {
namespace {

// Rounding of an FFT of these lengths: a few times the precision, root mean square
template <class Real>
constexpr double kRounding = std::is_same_v<Real, float> ? 1e-6 : 2e-15;

template <class Real>
class LaneFftOf : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(LaneFftOf, Precisions);

TYPED_TEST(LaneFftOf, IsTheTransformAndItsInverseInEveryLane) {
  constexpr Index kL = kLanes<TypeParam>;
  for (const Index length : {4, 8, 12, 20, 24, 40, 60, 160, 180}) {
    // Every radix; random numbers in the first half
    const LaneFft<TypeParam> fft(length);
    const auto data = LaneBuffer<TypeParam>::zeros(fft.buffer_size());
    const auto work = LaneBuffer<TypeParam>::zeros(fft.buffer_size());
    std::mt19937 engine(1);
    std::normal_distribution<double> normal;
    for (Index i = 0; i < kL * length; ++i) data.data()[i] = static_cast<TypeParam>(normal(engine));
    const std::vector<TypeParam> x(data.data(), data.data() + kL * length);
    TypeParam* const result = fft.forward(data.data(), work.data());
    double error = 0.0, norm = 0.0;
    for (Index lane = 0; lane < kL; ++lane)
      for (Index m = 0; m < length; ++m) {
        Complex sum = 0.0;
        for (Index i = 0; i < length / 2; ++i)
          sum += Complex(x[2 * kL * i + lane], x[2 * kL * i + kL + lane]) *
                 std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(i * m % length) /
                                     static_cast<double>(length));
        error +=
            std::norm(sum - Complex(result[2 * kL * m + lane], result[2 * kL * m + kL + lane]));
        norm += std::norm(sum);
      }
    EXPECT_LE(std::sqrt(error / norm), kRounding<TypeParam>) << "length " << length;

    const TypeParam* const back =
        fft.backward(result, result == data.data() ? work.data() : data.data());
    error = norm = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      error += std::pow(back[i] / static_cast<double>(length) - x[i], 2);
      norm += std::pow(x[i], 2);
    }
    EXPECT_LE(std::sqrt(error / norm), kRounding<TypeParam>) << "length " << length;
  }
}

TEST(LaneFft, FindsLengthsOfSmallFactors) {
  EXPECT_EQ(LaneFft<float>::fast_length(1), 4);
  EXPECT_EQ(LaneFft<float>::fast_length(13), 16);
  EXPECT_EQ(LaneFft<float>::fast_length(28), 32);  // 7 is no factor
  EXPECT_EQ(LaneFft<float>::fast_length(2000), 2000);
}

template <class Real>
class LaneConvolutionOf : public testing::Test {};
TYPED_TEST_SUITE(LaneConvolutionOf, Precisions);

TYPED_TEST(LaneConvolutionOf, IsTheDoubleSum) {
  for (const auto& [nx, ny] : {std::pair<Index, Index>{1, 1}, {3, 1}, {9, 4}, {21, 17}}) {
    std::vector<Complex> table;
    for (Index j = 0; j < ny; ++j)
      for (Index i = 0; i < nx; ++i)
        table.push_back(std::polar(1.0 / (1.0 + std::hypot(i, j)), 0.3 * std::hypot(i, j)));
    const LaneConvolution<TypeParam> convolution(nx, ny, table);
    GridData<TypeParam> grid(nx, ny);
    std::fill_n(grid.values.data(), grid.size, TypeParam(0));
    std::mt19937 engine(2);
    std::normal_distribution<double> normal;
    std::vector<Complex> charge;
    for (Index j = 0; j < ny; ++j)
      for (Index i = 0; i < nx; ++i) {
        grid.row(j)[i] = static_cast<TypeParam>(normal(engine));
        grid.row(j)[i + grid.stride] = static_cast<TypeParam>(normal(engine));
        charge.emplace_back(grid.row(j)[i], grid.row(j)[i + grid.stride]);
      }
    const LaneBuffer<TypeParam> workspace(convolution.workspace_size());
    convolution.apply(grid, workspace.data());
    double error = 0.0, norm = 0.0;
    for (Index j = 0; j < ny; ++j)
      for (Index i = 0; i < nx; ++i) {
        Complex sum = 0.0;
        for (Index l = 0; l < ny; ++l)
          for (Index k = 0; k < nx; ++k)
            sum += table[std::abs(i - k) + nx * std::abs(j - l)] * charge[k + nx * l];
        error += std::norm(sum - Complex(grid.row(j)[i], grid.row(j)[i + grid.stride]));
        norm += std::norm(sum);
      }
    EXPECT_LE(std::sqrt(error / norm), kRounding<TypeParam>) << nx << " x " << ny;
  }
}

}  // namespace
}  // namespace floe::fmm::pfft
