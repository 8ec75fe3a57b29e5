#pragma once

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <source_location>
#include <span>
#include <string>

/// Comparisons that the tests share.
namespace floe::test {

/// ‖actual - expected‖ / ‖expected‖ in the Frobenius norm, over vectors and matrices.
template <class A, class B>
double relative_error(const Eigen::MatrixBase<A>& actual, const Eigen::MatrixBase<B>& expected) {
  return (actual - expected).norm() / expected.norm();
}

/// Expects |actual - expected| ≤ relative·|expected| + absolute, for real or complex numbers; NaN
/// fails. `what` is told on failure.
template <class Number>
void expect_close(Number actual, Number expected, double relative, double absolute = 0.0,
                  const std::string& what = {},
                  const std::source_location place = std::source_location::current()) {
  const double difference = std::abs(actual - expected);
  const double allowed = relative * std::abs(expected) + absolute;
  if (!(difference <= allowed))
    ADD_FAILURE_AT(place.file_name(), static_cast<int>(place.line()))
        << what << (what.empty() ? "" : ": ") << "actual " << actual << ", expected " << expected
        << ", difference " << difference << ", allowed " << allowed;
}

/// The same for whole vectors and matrices, every entry within relative·max|expected| + absolute.
/// Names the worst entry.
template <class A, class B>
void expect_all_close(const Eigen::MatrixBase<A>& actual, const Eigen::MatrixBase<B>& expected,
                      double relative, double absolute = 0.0, const std::string& what = {},
                      const std::source_location place = std::source_location::current()) {
  const char* file = place.file_name();
  const int line = static_cast<int>(place.line());
  if (actual.rows() != expected.rows() || actual.cols() != expected.cols()) {
    ADD_FAILURE_AT(file, line) << what << (what.empty() ? "" : ": ") << "size " << actual.rows()
                               << " × " << actual.cols() << ", expected " << expected.rows()
                               << " × " << expected.cols();
    return;
  }
  if (expected.size() == 0) return;
  const double allowed = relative * expected.cwiseAbs().maxCoeff() + absolute;
  Eigen::Index row = 0, column = 0;
  double worst = -1.0;
  for (Eigen::Index j = 0; j < expected.cols(); ++j)
    for (Eigen::Index i = 0; i < expected.rows(); ++i) {
      const double difference = std::abs(actual(i, j) - expected(i, j));
      if (!std::isnan(worst) && !(difference <= worst)) worst = difference, row = i, column = j;
    }
  if (!(worst <= allowed))
    ADD_FAILURE_AT(file, line) << what << (what.empty() ? "" : ": ") << "entry (" << row << ", "
                               << column << ") is " << actual(row, column) << ", expected "
                               << expected(row, column) << ", difference " << worst << ", allowed "
                               << allowed;
}

/// The rate p of error ≈ C hᵖ: the slope of log(error) over log(h) by least squares.
inline double observed_order(std::span<const double> h, std::span<const double> error) {
  const auto count = static_cast<double>(h.size());
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const double u = std::log(h[i]), v = std::log(error[i]);
    x += u, y += v, xx += u * u, xy += u * v;
  }
  return (count * xy - x * y) / (count * xx - x * x);
}

}  // namespace floe::test
