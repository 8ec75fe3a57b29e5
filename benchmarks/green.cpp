// T11: the Green function from its table against Boost's J0 + Y0 at the same distances, in turn;
// relative error of the table against the exact function.
#include "f1.hpp"
#include "figures.hpp"

#include <floe/green/green_table.hpp>

#include <boost/math/special_functions/bessel.hpp>
#include <omp.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace floe::bench {
namespace {

Figures compare(double nu, double depth, Index count) {
  const green::GreenFunction exact(nu, depth);
  const double reach = 310.0;
  const green::GreenTable table(exact, reach);
  const double setup = seconds_of([&] { const green::GreenTable again(exact, reach); });

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
  if (!std::isfinite(sum)) std::exit(1);
  return {.nodes = static_cast<double>(count),
          .seconds = median(ours) / static_cast<double>(count),
          .anchor = median(boost) / static_cast<double>(count),
          .error = table.sampled_error(2000),
          .bytes = 0.0,
          .more = {{"setup_s", setup}}};
}

}  // namespace
}  // namespace floe::bench

int main(int argc, char** argv) {
  using namespace floe::bench;
  omp_set_num_threads(1);
  for (const double depth : {1.0, 58.5, std::numeric_limits<double>::infinity()})
    add_measurement("T11/green_table/depth=" + std::to_string(depth),
                    [=] { return compare(1.01 * 1.01 / 9.81, depth, 200000); });
  return run_measurements(argc, argv);
}
