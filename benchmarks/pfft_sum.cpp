// PfftSum against F1 and the direct sum: nodes of a jittered Q8 mesh of 5 : 1 plates, random and
// smooth charges, CPU time on one thread, medians.
//   bench_pfft_sum [nx of elements] [tolerance…]

#include "f1.hpp"

#include <floe/fmm/pfft_sum.hpp>
#include <floe/fmm/sampled_error.hpp>
#include <floe/green/green_table.hpp>

#include <omp.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>

namespace {

using namespace floe;

constexpr double kElement = 3.0;  // E [m]

// Nodes of nx × nx/5 elements in the order of a mesh generator's rows, moved by up to E/10
Points2 q8_nodes(Index nx) {
  const Index ny = std::max<Index>(1, nx / 5);
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> jitter(-0.1, 0.1);
  std::vector<Point2> nodes;
  for (Index j = 0; j <= 2 * ny; ++j)
    for (Index i = 0; i <= 2 * nx; ++i)
      if (i % 2 == 0 || j % 2 == 0)
        nodes.emplace_back(kElement * (0.5 * double(i) + jitter(engine)),
                           kElement * (0.5 * double(j) + jitter(engine)));
  Points2 points(2, static_cast<Index>(nodes.size()));
  for (Index k = 0; k < points.cols(); ++k) points.col(k) = nodes[k];
  return points;
}

struct Charges {
  MatXcd random, smooth;
};

Charges make_charges(const Points2& points, Index columns) {
  std::mt19937 engine(2);
  std::normal_distribution<double> normal;
  Charges charges{MatXcd(points.cols(), columns), MatXcd(points.cols(), columns)};
  for (Index c = 0; c < columns; ++c)
    for (Index i = 0; i < points.cols(); ++i) {
      charges.random(i, c) = {normal(engine), normal(engine)};
      charges.smooth(i, c) = 1.0 + std::cos(2e-3 * double(c + 1) * points(0, i));
    }
  return charges;
}

double repeated(const fmm::PfftSum& sum, const MatXcd& charges, MatXcd& potentials, int times) {
  std::vector<double> seconds;
  for (int repeat = 0; repeat < times; ++repeat)
    seconds.push_back(benchmark::seconds_of([&] { sum.apply(charges, potentials); }));
  return benchmark::median(seconds);
}

void measure(const Points2& points, double tolerance, double k, double f1,
             const fmm::PfftDesign* design) {
  const green::GreenFunction green(k, std::numeric_limits<double>::infinity());
  const Point2 size = points.rowwise().maxCoeff() - points.rowwise().minCoeff();
  const green::GreenTable table(green, 1.2 * size.norm());
  const fmm::PfftOptions options{.tolerance = tolerance,
                                 .max_wavenumber = green.wavenumber(),
                                 .typical_kernel = design ? nullptr : &table};
  std::shared_ptr<const fmm::PfftPlan> plan;
  const double plan_time = benchmark::seconds_of([&] {
    plan = design ? std::make_shared<const fmm::PfftPlan>(points, points, options, *design)
                  : std::make_shared<const fmm::PfftPlan>(points, points, options);
  });
  std::unique_ptr<fmm::PfftSum> sum;
  const double setup =
      benchmark::seconds_of([&] { sum = std::make_unique<fmm::PfftSum>(plan, table); });

  const Charges charges = make_charges(points, 1);
  MatXcd random(points.cols(), 1), smooth(points.cols(), 1);
  const double one = repeated(*sum, charges.random, random, 5);
  sum->apply(charges.smooth, smooth);
  double eight = 0.0;
  if (!design) {
    const Charges block = make_charges(points, 8);
    MatXcd result(points.cols(), 8);
    eight = repeated(*sum, block.random, result, 3) / 8.0;
  }
  MatXcd far(points.cols(), 1);
  const double far_time = benchmark::seconds_of([&] { sum->far_apply(charges.random, far); });

  const fmm::DirectSum truth(points, points, table);
  const fmm::PfftDesign& d = plan->design();
  std::printf(
      "N %td threads %d tolerance %.0e w %d r %.1f h/E %.2f grid %td x %td near %.0f "
      "error random %.1e smooth %.1e | apply %.1f ms (far %.1f, estimate %.1f) = %.1f F1, "
      "of 8: %.2f | plan %.2f s, setup %.1f applications | %.0f bytes a node\n",
      points.cols(), omp_get_max_threads(), tolerance, d.stencil, d.near_radius,
      d.spacing / kElement, d.nx, d.ny, d.near_pairs / double(points.cols()),
      fmm::sampled_error(truth, charges.random, random),
      fmm::sampled_error(truth, charges.smooth, smooth), 1e3 * one, 1e3 * far_time,
      1e-6 * d.nanoseconds, f1 > 0.0 ? one / f1 : 0.0, eight / one, plan_time, setup / one,
      (sum->memory() + plan->memory()) / double(points.cols()));
  std::fflush(stdout);
}

double f1_seconds(Index nx) {
  const benchmark::F1 anchor(nx + 1, nx / 5 + 1, FFTW_MEASURE);
  std::vector<double> seconds;
  for (int repeat = 0; repeat < 11; ++repeat) seconds.push_back(anchor.seconds());
  return benchmark::median(seconds);
}

}  // namespace

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  const Index nx = argc > 1 ? std::atol(argv[1]) : 690;
  const Points2 points = q8_nodes(nx);
  const double k = 122.0 / (kElement * double(nx));  // kL = 122
  if (argc > 2 && std::atof(argv[2]) == 0.0) {
    // Error of every stencil and radius, whatever the spacing (the table of the design)
    const double h = argc > 3 ? std::atof(argv[3]) : 0.7;
    for (int w = 3; w <= 10; ++w)
      for (int r = 1; r <= 8; ++r) {
        const fmm::PfftDesign design{
            .stencil = w, .near_radius = double(r), .spacing = h * kElement};
        measure(points, 1e-7, 1e-6, 0.0, &design);
      }
    return 0;
  }
  std::vector<double> tolerances;
  for (int a = 2; a < argc; ++a) tolerances.push_back(std::atof(argv[a]));
  if (tolerances.empty()) tolerances = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7};
  const double f1 = f1_seconds(nx);
  for (const double tolerance : tolerances) measure(points, tolerance, k, f1, nullptr);
}
