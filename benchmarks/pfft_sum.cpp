// PfftSum against F1 and the direct sum: nodes of a jittered Q8 mesh of 5 : 1 plates, random and
// smooth charges, CPU time on one thread, medians.

#include "f1.hpp"
#include "figures.hpp"

#include <floe/fmm/pfft_sum.hpp>
#include <floe/fmm/sampled_error.hpp>
#include <floe/green/green_table.hpp>

#include <omp.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace {

using namespace floe;
using bench::Figures;
using bench::median;
using bench::seconds_of;

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

Figures measure(const Points2& points, double tolerance, double k, const bench::F1* anchor,
                const fmm::PfftDesign* design) {
  const green::GreenFunction green(k, std::numeric_limits<double>::infinity());
  const Point2 size = points.rowwise().maxCoeff() - points.rowwise().minCoeff();
  const green::GreenTable table(green, 1.2 * size.norm());
  const fmm::PfftOptions options{.tolerance = tolerance,
                                 .max_wavenumber = green.wavenumber(),
                                 .typical_kernel = design ? nullptr : &table};
  std::shared_ptr<const fmm::PfftPlan> plan;
  const double plan_time = seconds_of([&] {
    plan = design ? std::make_shared<const fmm::PfftPlan>(points, points, options, *design)
                  : std::make_shared<const fmm::PfftPlan>(points, points, options);
  });
  std::unique_ptr<fmm::PfftSum> sum;
  const double setup = seconds_of([&] { sum = std::make_unique<fmm::PfftSum>(plan, table); });

  // One column and eight, in turn with F1
  constexpr Index kColumns = 8;
  const Charges charges = make_charges(points, 1), block = make_charges(points, kColumns);
  MatXcd random(points.cols(), 1), smooth = random, result(points.cols(), kColumns);
  std::vector<double> f1_times, far_times, times, eight_times, far_eight_times;
  for (int round = 0; round < (anchor ? 9 : 1); ++round) {
    if (anchor) f1_times.push_back(anchor->seconds());
    far_times.push_back(seconds_of([&] { sum->far_apply(charges.random, random); }));
    times.push_back(seconds_of([&] { sum->apply(charges.random, random); }));
    if (round % 3 != 0) continue;
    eight_times.push_back(seconds_of([&] { sum->apply(block.random, result); }) / kColumns);
    far_eight_times.push_back(seconds_of([&] { sum->far_apply(block.random, result); }) / kColumns);
  }
  sum->apply(charges.smooth, smooth);

  const fmm::DirectSum truth(points, points, table);
  const fmm::PfftDesign& d = plan->design();
  const double f1 = anchor ? median(f1_times) : 0.0, one = median(times), far = median(far_times);
  return {.nodes = static_cast<double>(points.cols()),
          .tolerance = tolerance,
          .seconds = one,
          .anchor = f1,
          .error = fmm::sampled_error(truth, charges.random, random),
          .bytes = sum->memory() + plan->memory(),
          .more = {{"error_smooth", fmm::sampled_error(truth, charges.smooth, smooth)},
                   {"stencil", static_cast<double>(d.stencil)},
                   {"near_radius", d.near_radius},
                   {"spacing", d.spacing / kElement},
                   {"estimate_s", 1e-9 * d.nanoseconds},
                   {"far_s", far},
                   {"of_eight_share", median(eight_times) / one},
                   {"far_of_eight_share", median(far_eight_times) / far},
                   {"plan_s", plan_time},
                   {"setup_applications", setup / one}}};
}

// kL = 122; with an anchor, or for a design of its own
Figures measure(Index nx, double tolerance, const fmm::PfftDesign* design) {
  const Points2 points = q8_nodes(nx);
  if (design) return measure(points, tolerance, 1e-6, nullptr, design);
  const bench::F1 anchor(nx + 1, nx / 5 + 1, FFTW_MEASURE);
  return measure(points, tolerance, 122.0 / (kElement * double(nx)), &anchor, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  for (const char* const tolerance : {"1e-2", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7"})
    bench::add_measurement(std::string("pfft_sum/nx=690/tolerance=") + tolerance,
                           [=] { return measure(690, std::atof(tolerance), nullptr); });
  // Error of every stencil and radius, whatever the spacing: the table of the design
  for (int w = 4; w <= 8; ++w)
    for (const double r :
         {1.4, 2.0, 2.2, 2.5, 3.0, 3.1, 3.5, 4.0, 4.2, 5.0, 5.5, 6.0, 6.5, 7.0, 7.5, 8.0})
      bench::add_measurement(
          "pfft_design/w=" + std::to_string(w) + "/r=" + std::to_string(r) + "/full", [=] {
            const fmm::PfftDesign design{.stencil = w, .near_radius = r, .spacing = 0.7 * kElement};
            return measure(200, 1e-7, &design);
          });
  return bench::run_measurements(argc, argv);
}
