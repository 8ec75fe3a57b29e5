#include <floe/fmm/direct_sum.hpp>
#include <floe/fmm/pfft_sum.hpp>
#include <floe/fmm/sampled_error.hpp>
#include <floe/green/green_table.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

namespace floe::green {
namespace {

// A plate of 2 : 1 with `count` points anywhere on it; D = 1 is its length
Points2 random_points(Index count) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Points2 points(2, count);
  for (Index i = 0; i < count; ++i) points.col(i) << uniform(engine), 0.5 * uniform(engine);
  return points;
}

double wave_depth(double k, double kh) { return kh / k; }

// The water's own kernel: from waves longer than the plate to 80 of them, shallow to deep
TEST(twin_PfftSum, KeepsItsToleranceForTheGreenFunction) {
  const Index count = 4000;
  for (const bool graded : {false, true}) {
    Points2 points = random_points(count);
    // Denser and denser towards one end
    if (graded) points.row(0) = points.row(0).array().square();
    MatXcd charges(count, 2);
    std::mt19937 engine(2);
    std::normal_distribution<double> normal;
    for (Index i = 0; i < count; ++i) {
      charges(i, 0) = {normal(engine), normal(engine)};
      charges(i, 1) = 1.0 + points(0, i);
    }
    for (const double k : {0.1, 10.0, 100.0, 500.0})
      for (const double kh : {0.02, 1.0, std::numeric_limits<double>::infinity()})
        for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
          const double nu = std::isinf(kh) ? k : k * std::tanh(kh);
          const GreenFunction green(nu, wave_depth(k, kh));
          const GreenTable table(green, 2.0);
          const auto plan = std::make_shared<const fmm::PfftPlan>(
              points, points,
              fmm::PfftOptions{.tolerance = tolerance,
                               .max_wavenumber = green.wavenumber(),
                               .typical_kernel = &table});
          const fmm::PfftSum sum(plan, table);
          const fmm::DirectSum truth(points, points, table);
          MatXcd potentials(count, 2);
          sum.apply(charges, potentials);
          for (Index column = 0; column < 2; ++column)
            EXPECT_LE(fmm::sampled_error(truth, charges.col(column), potentials.col(column)),
                      tolerance)
                << "k = " << k << " kh = " << kh << " column " << column << " graded " << graded;
        }
  }
}

}  // namespace
}  // namespace floe::green
