// Kernel sums on the nodes of a rectangle of Q8 elements, L/B = 5, with the water's Green function:
//   bench_kernel_sums [elements along the length] [tolerance] [kL] [kh; inf: deep] [leaf size]
// One line: CPU times, medians, and their ratios to F1, timed in turn with the sums; random and
// smooth charges, one column and eight.

#include "f1.hpp"

#include <floe/fmm/direct_sum.hpp>
#include <floe/fmm/multipole_sum.hpp>
#include <floe/fmm/sampled_error.hpp>
#include <floe/green/green_table.hpp>

#include <omp.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace floe {
namespace {

using benchmark::median;
using benchmark::seconds_of;

// Corners and middles of the edges of nx × ny square elements of size 1
Points2 q8_nodes(int nx, int ny) {
  Points2 points(2, (nx + 1) * (ny + 1) + nx * (ny + 1) + (nx + 1) * ny);
  Index count = 0;
  for (int j = 0; j <= 2 * ny; ++j)
    for (int i = 0; i <= 2 * nx; ++i)
      if (i % 2 == 0 || j % 2 == 0) points.col(count++) = Point2(0.5 * i, 0.5 * j);
  return points;
}

MatXcd random_charges(Index count, Index columns) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  return MatXcd::NullaryExpr(count, columns,
                             [&] { return Complex(normal(random), normal(random)); });
}

}  // namespace
}  // namespace floe

int main(int argc, char** argv) {
  using namespace floe;
  const auto argument = [&](int i, double otherwise) {
    return argc > i ? std::strtod(argv[i], nullptr) : otherwise;
  };
  const int nx = static_cast<int>(argument(1, 690)), ny = nx / 5;
  const double tolerance = argument(2, 1e-4), kL = argument(3, 150.0), kh = argument(4, INFINITY);
  const auto leaf_size = static_cast<Index>(argument(5, fmm::MultipoleOptions{}.leaf_size));

  const Points2 points = q8_nodes(nx, ny);
  const double k = kL / nx, depth = kh / k, nu = std::isinf(kh) ? k : k * std::tanh(kh);
  std::shared_ptr<const fmm::MultipolePlan> plan;
  const double plan_seconds = seconds_of([&] {
    plan = std::make_shared<fmm::MultipolePlan>(points, points,
                                                fmm::MultipoleOptions{.leaf_size = leaf_size});
  });
  const green::GreenTable kernel(green::GreenFunction(nu, depth), plan->reach());
  std::unique_ptr<fmm::MultipoleSum> sum;
  const double setup_seconds =
      seconds_of([&] { sum = std::make_unique<fmm::MultipoleSum>(plan, kernel, tolerance); });

  // One column and eight, in turn with F1
  constexpr Index kColumns = 8;
  const MatXcd block = random_charges(points.cols(), kColumns), charges = block.leftCols(1);
  MatXcd potentials(points.cols(), 1), block_potentials(points.cols(), kColumns);
  const benchmark::F1 anchor(nx + 1, ny + 1, FFTW_MEASURE);
  std::vector<double> f1_times, far_times, times, eight_times, far_eight_times;
  for (int round = 0; round < 9; ++round) {
    f1_times.push_back(anchor.seconds());
    far_times.push_back(seconds_of([&] { sum->far_apply(charges, potentials); }));
    times.push_back(seconds_of([&] { sum->apply(charges, potentials); }));
    if (round % 3 != 0) continue;
    eight_times.push_back(seconds_of([&] { sum->apply(block, block_potentials); }) / kColumns);
    far_eight_times.push_back(seconds_of([&] { sum->far_apply(block, block_potentials); }) /
                              kColumns);
  }
  const fmm::DirectSum truth(points, points, kernel);
  const double error = fmm::sampled_error(truth, charges, potentials, 100);
  const MatXcd smooth = (Complex(0.0, k) * points.row(0).transpose()).array().exp();
  sum->apply(smooth, potentials);
  const double smooth_error = fmm::sampled_error(truth, smooth, potentials, 100);

  const double f1 = median(f1_times), time = median(times), far = median(far_times);
  std::printf(
      "multipole N %td threads %d kL %g kh %g leaf %td tolerance %.0e error random %.1e smooth "
      "%.1e "
      "| F1 %.1f ms, apply %.1f ms = %.1f F1 (far %.1f F1), of 8 each %.1f ms = %.2f (far %.2f) "
      "| plan %.2f s, setup %.1f applications | %.0f + %.0f bytes a node | ranks",
      points.cols(), omp_get_max_threads(), kL, kh, leaf_size, tolerance, error, smooth_error,
      1e3 * f1, 1e3 * time, time / f1, far / f1, 1e3 * median(eight_times),
      median(eight_times) / time, median(far_eight_times) / far, plan_seconds, setup_seconds / time,
      sum->memory() / static_cast<double>(points.cols()),
      plan->memory() / static_cast<double>(points.cols()));
  for (const Index rank : sum->ranks()) std::printf(" %td", rank);
  std::printf("\n");
}
