// Kernel sums on the nodes of a rectangle of Q8 elements, L/B = 5, with the water's Green function:
//   bench_kernel_sums [elements along the length] [tolerance] [kL] [kh; inf: deep] [leaf size]
// One line: CPU times, medians, and their ratios to F1, timed in turn with the sums; random and
// smooth charges, one column and eight.

#include "f1.hpp"
#include "figures.hpp"

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

using bench::median;
using bench::seconds_of;

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

bench::Figures measure(int nx, double tolerance, double kL, double kh, Index leaf_size) {
  const int ny = nx / 5;
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
  const bench::F1 anchor(nx + 1, ny + 1, FFTW_MEASURE);
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
  return {.nodes = static_cast<double>(points.cols()),
          .tolerance = tolerance,
          .seconds = time,
          .anchor = f1,
          .error = error,
          .bytes = sum->memory() + plan->memory(),
          .more = {{"error_smooth", smooth_error},
                   {"far_ratio", far / f1},
                   {"of_eight_share", median(eight_times) / time},
                   {"far_of_eight_share", median(far_eight_times) / far},
                   {"plan_s", plan_seconds},
                   {"setup_applications", setup_seconds / time}}};
}

}  // namespace
}  // namespace floe

int main(int argc, char** argv) {
  using namespace floe;
  omp_set_num_threads(1);
  const auto add = [](const std::string& name, double tolerance, double kh, Index leaf) {
    bench::add_measurement(name, [=] { return measure(690, tolerance, 150.0, kh, leaf); });
  };
  const Index leaf = fmm::MultipoleOptions{}.leaf_size;
  add("T4/fmm_sum/tolerance=1e-4", 1e-4, INFINITY, leaf);
  add("T5/fmm_sum/tolerance=3e-6", 3e-6, INFINITY, leaf);
  add("fmm_sum/tolerance=1e-2/full", 1e-2, INFINITY, leaf);
  add("fmm_sum/tolerance=1e-6/full", 1e-6, INFINITY, leaf);
  add("fmm_sum/tolerance=1e-9/full", 1e-9, INFINITY, leaf);
  add("fmm_sum/tolerance=1e-4/kh=1/full", 1e-4, 1.0, leaf);
  add("fmm_sum/tolerance=1e-4/kh=0.02/full", 1e-4, 0.02, leaf);
  add("fmm_sum/tolerance=1e-4/leaf=32/full", 1e-4, INFINITY, 32);
  return bench::run_measurements(argc, argv);
}
