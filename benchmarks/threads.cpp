// What a second thread gains: wall and CPU time of the operators on 287 thousand nodes with one
// thread and with two, in turn, medians.
//   bench_threads [elements along the plate = 690] [tolerance = 1e-4]
#include "f1.hpp"

#include <floe/bem/fast_pressure_operator.hpp>
#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/mesh/rectangle.hpp>

#include <omp.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace floe::benchmark {
namespace {

constexpr double kDepth = 58.5, kNu = 1.01 * 1.01 / 9.81;

struct Times {
  std::vector<double> wall, cpu;
};

template <class Work>
void add_time(Times& times, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  times.cpu.push_back(seconds_of(work));
  times.wall.push_back(
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

void compare(const char* name, const krylov::LinearOperator& op, Index columns) {
  const MatXcd x = MatXcd::Random(op.size(), columns);
  MatXcd one(op.size(), columns), two(op.size(), columns);
  Times single, pair;
  for (int repeat = 0; repeat < 9; ++repeat) {
    omp_set_num_threads(1);
    add_time(single, [&] { op.apply(x, one); });
    omp_set_num_threads(2);
    add_time(pair, [&] { op.apply(x, two); });
  }
  const double wall = median(single.wall), cpu = median(single.cpu);
  std::printf(
      "%-10s N %ld columns %ld one thread %.1f ms two threads %.1f ms wall 1/%.2f CPU %.2f "
      "difference %.1e\n",
      name, static_cast<long>(op.size()), static_cast<long>(columns), 1e3 * wall,
      1e3 * median(pair.wall), wall / median(pair.wall), median(pair.cpu) / cpu,
      (one - two).norm() / one.norm());
  std::fflush(stdout);
}

}  // namespace
}  // namespace floe::benchmark

int main(int argc, char** argv) {
  using namespace floe;
  using namespace floe::benchmark;
  const int nx = argc > 1 ? std::atoi(argv[1]) : 690;
  const double tolerance = argc > 2 ? std::atof(argv[2]) : 1e-4;
  const mesh::Q8Mesh mesh =
      mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = nx, .ny = nx / 5});
  const green::GreenFunction exact(kNu, kDepth);
  const green::GreenTable green(exact, 1300.0);
  {
    const auto plan = std::make_shared<const bem::LatticePlan>(mesh);
    const bem::LatticePressureOperator lattice(plan, green);
    for (const Index columns : {1, 8}) compare("lattice", lattice, columns);
  }
  for (const bem::SumEngine engine : {bem::SumEngine::kPfft, bem::SumEngine::kMultipole}) {
    const auto plan = std::make_shared<const bem::FastPressurePlan>(
        mesh, bem::FastOptions{
                  .engine = engine, .tolerance = tolerance, .max_wavenumber = exact.wavenumber()});
    const bem::FastPressureOperator fast(plan, green);
    for (const Index columns : {1, 8})
      compare(engine == bem::SumEngine::kPfft ? "pfft" : "multipole", fast, columns);
  }
}
