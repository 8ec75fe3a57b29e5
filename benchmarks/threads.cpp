// What a second thread gains: wall and CPU time of the operators on 287 thousand nodes with one
// thread and with two, in turn, medians.
#include "f1.hpp"
#include "figures.hpp"

#include <floe/bem/fast_pressure_operator.hpp>
#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/estimate.hpp>
#include <floe/mesh/rectangle.hpp>

#include <omp.h>

#include <chrono>
#include <string>
#include <vector>

namespace floe::bench {
namespace {

constexpr double kDepth = 58.5, kNu = 1.01 * 1.01 / 9.81;

struct Times {
  double wall, cpu;
};

template <class Work>
Times times_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  const double cpu = seconds_of(work);
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), cpu};
}

Figures compare(const krylov::LinearOperator& op, Index columns, double tolerance) {
  const MatXcd x = MatXcd::Random(op.size(), columns);
  MatXcd one(op.size(), columns), two(op.size(), columns);
  std::vector<double> wall, wall_of_one, cpu_ratio;
  for (int repeat = 0; repeat < 21; ++repeat) {
    omp_set_num_threads(1);
    const Times single = times_of([&] { op.apply(x, one); });
    omp_set_num_threads(2);
    const Times pair = times_of([&] { op.apply(x, two); });
    wall.push_back(pair.wall);
    wall_of_one.push_back(single.wall);
    cpu_ratio.push_back(pair.cpu / single.cpu);
  }
  return {.nodes = static_cast<double>(op.size()),
          .tolerance = tolerance,
          .seconds = median(wall),
          .anchor = median(wall_of_one),
          .error = (one - two).norm() / one.norm(),
          .bytes = 0.0,
          .more = {{"columns", static_cast<double>(columns)}, {"cpu_ratio", median(cpu_ratio)}}};
}

// With the plate of 690 × 138 elements
Figures measure(SolverMethod method, Index columns) {
  constexpr double kTolerance = 1e-4;
  const mesh::Q8Mesh mesh =
      mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = 690, .ny = 138});
  const green::GreenFunction exact(kNu, kDepth);
  const green::GreenTable green(exact, 1300.0);
  if (method == SolverMethod::kLattice)
    return compare(
        bem::LatticePressureOperator(std::make_shared<const bem::LatticePlan>(mesh), green),
        columns, 0.0);
  const auto engine =
      method == SolverMethod::kPfft ? bem::SumEngine::kPfft : bem::SumEngine::kMultipole;
  const auto plan = std::make_shared<const bem::FastPressurePlan>(
      mesh, bem::FastOptions{
                .engine = engine, .tolerance = kTolerance, .max_wavenumber = exact.wavenumber()});
  return compare(bem::FastPressureOperator(plan, green), columns, kTolerance);
}

}  // namespace
}  // namespace floe::bench

int main(int argc, char** argv) {
  using namespace floe;
  for (const SolverMethod method :
       {SolverMethod::kLattice, SolverMethod::kPfft, SolverMethod::kFmm})
    for (const Index columns : {1, 8})
      bench::add_measurement(std::string("T14/threads_wall/") + method_name(method) +
                                 "/columns=" + std::to_string(columns),
                             [=] { return bench::measure(method, columns); });
  return bench::run_measurements(argc, argv);
}
