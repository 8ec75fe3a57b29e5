// T11: the Green function from its table against Boost's J0 + Y0 at the same distances, in turn;
// relative error of the table against the exact function.
//   bench_green [distances = 200000]
#include "f1.hpp"

#include <floe/green/green_table.hpp>

#include <boost/math/special_functions/bessel.hpp>
#include <omp.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>

namespace floe::benchmark {
namespace {

void compare(double nu, double depth, Index count) {
  const green::GreenFunction exact(nu, depth);
  const double reach = 310.0;
  std::vector<double> table_setup;
  const green::GreenTable table(exact, reach);
  table_setup.push_back(seconds_of([&] { const green::GreenTable again(exact, reach); }));

  // Distances as a plate has them: log-uniform from a centimetre
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> exponent(std::log(0.01), std::log(reach));
  std::vector<double> distance(static_cast<std::size_t>(count));
  for (double& r : distance) r = std::exp(exponent(engine));
  std::vector<Complex> value(distance.size());
  const double k = exact.wavenumber();

  std::vector<double> ours, boost;
  double sum = 0.0;
  for (int repeat = 0; repeat < 9; ++repeat) {
    ours.push_back(seconds_of([&] { table.evaluate(distance, value); }));
    boost.push_back(seconds_of([&] {
      for (const double r : distance)
        sum += boost::math::cyl_bessel_j(0, k * r) + boost::math::cyl_neumann(0, k * r);
    }));
  }
  const double each = median(ours) / static_cast<double>(count);
  const double anchor = median(boost) / static_cast<double>(count);
  std::printf(
      "table nu %.3f depth %.1f N %ld threads 1 time %.2f ns a value, Boost J0 + Y0 %.1f ns, "
      "ratio 1/%.1f, error %.1e, set-up %.1f ms\n",
      nu, depth, static_cast<long>(count), 1e9 * each, 1e9 * anchor, anchor / each,
      table.sampled_error(2000), 1e3 * median(table_setup));
  if (!std::isfinite(sum)) std::exit(1);
}

}  // namespace
}  // namespace floe::benchmark

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  const long count = argc > 1 ? std::atol(argv[1]) : 200000;
  for (const double depth : {1.0, 58.5, std::numeric_limits<double>::infinity()})
    floe::benchmark::compare(1.01 * 1.01 / 9.81, depth, count);
}
