#include <expect.hpp>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <array>
#include <complex>
#include <limits>

namespace floe::test {
namespace {

TEST(ExpectClose, AcceptsWithinAndFailsBeyondTheTolerance) {
  expect_close(1.0 + 1e-9, 1.0, 2e-9);
  expect_close(1e-12, 0.0, 0.0, 1e-11);
  expect_close(std::complex<double>(0.0, 2.0), std::complex<double>(0.0, 2.001), 1e-3);
  EXPECT_NONFATAL_FAILURE(expect_close(1.1, 1.0, 1e-2, 0.0, "depth"), "depth: actual 1.1");
  EXPECT_NONFATAL_FAILURE(expect_close(std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0),
                          "actual nan");
}

TEST(ExpectAllClose, NamesTheWorstEntry) {
  Eigen::Matrix2d expected, actual;
  expected << 1, 2, 3, 4;
  actual = expected;
  expect_all_close(actual, expected, 0.0);
  actual(0, 1) = 2.5;
  EXPECT_NONFATAL_FAILURE(expect_all_close(actual, expected, 1e-3), "entry (0, 1) is 2.5");
  actual(1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NONFATAL_FAILURE(expect_all_close(actual, expected, 1.0), "entry (1, 0) is nan");
  EXPECT_NONFATAL_FAILURE(expect_all_close(Eigen::Vector2d::Zero(), expected, 1.0), "size 2 × 1");
}

TEST(ObservedOrder, IsTheExponentOfAPowerLaw) {
  const std::array<double, 3> h{0.4, 0.2, 0.1};
  const std::array<double, 3> error{3.0 * 0.064, 3.0 * 0.008, 3.0 * 0.001};
  expect_close(observed_order(h, error), 3.0, 1e-13);  // a few roundings of logarithms
}

}  // namespace
}  // namespace floe::test
