// Small fixed cases of which benchmarks/guard.py counts instructions, iterations and bytes, and
// compares them with benchmarks/baseline.json.
//   bench_guard            the names of the cases
//   bench_guard CASE       runs one, one thread; prints "figure value" lines
#include "allocated.hpp"
#include "curved_plate.hpp"
#include "f1.hpp"

#include <floe/bem/damped_wave_preconditioner.hpp>
#include <floe/bem/fast_pressure_operator.hpp>
#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/krylov/gmres.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/plate/dry_modes.hpp>
#include <floe/sea_statistics.hpp>

#include <omp.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <string>

namespace floe::bench {

/// What is counted: the work of a case without its preparation.
__attribute__((noinline)) void guarded(const std::function<void()>& work) {
  const double before = allocated_bytes();
  work();
  std::printf("allocated_bytes %.0f\n", allocated_bytes() - before);
}

namespace {

constexpr double kNu = 1.01 * 1.01 / 9.81, kDepth = 58.5;

mesh::Q8Mesh rectangle(int nx) {
  return mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = nx, .ny = nx / 5});
}

green::GreenTable green_table() { return {green::GreenFunction(kNu, kDepth), 1300.0}; }

// Charges without any order, the same on every machine
MatXcd columns_for(Index rows, Index columns) {
  MatXcd x(rows, columns);
  for (Index j = 0; j < columns; ++j)
    for (Index i = 0; i < rows; ++i)
      x(i, j) = std::polar(1.0, 0.7 * double(i) * double(i % 97) + double(j));
  return x;
}

void apply(const krylov::LinearOperator& op, Index columns) {
  const MatXcd x = columns_for(op.size(), columns);
  MatXcd y(op.size(), columns);
  op.apply(x, y);
  guarded([&] { op.apply(x, y); });
}

std::shared_ptr<const bem::FastPressurePlan> plan_of(const mesh::Q8Mesh& mesh,
                                                     bem::SumEngine engine) {
  return std::make_shared<const bem::FastPressurePlan>(
      mesh, bem::FastOptions{.engine = engine,
                             .tolerance = 1e-4,
                             .max_wavenumber = green::GreenFunction(kNu, kDepth).wavenumber()});
}

void near_field(bem::SumEngine engine) {
  const mesh::Q8Mesh mesh = curved_plate(25);
  const green::GreenTable green = green_table();
  const auto plan = plan_of(mesh, engine);
  std::unique_ptr<const bem::FastPressureOperator> op;
  guarded([&] { op = std::make_unique<const bem::FastPressureOperator>(plan, green); });
  std::printf("memory_bytes %.0f\n", op->memory() + plan->memory());
}

void plan_near_field() {
  const mesh::Q8Mesh mesh = curved_plate(15);
  guarded([&] { static_cast<void>(plan_of(mesh, bem::SumEngine::kPfft)); });
}

void fast_apply(bem::SumEngine engine) {
  const mesh::Q8Mesh mesh = curved_plate(30);
  const green::GreenTable green = green_table();
  apply(bem::FastPressureOperator(plan_of(mesh, engine), green), 2);
}

void lattice_apply() {
  const green::GreenTable green = green_table();
  apply(
      bem::LatticePressureOperator(std::make_shared<const bem::LatticePlan>(rectangle(100)), green),
      2);
}

void lattice_setup() {
  const green::GreenTable green = green_table();
  const auto plan = std::make_shared<const bem::LatticePlan>(rectangle(60));
  guarded([&] { const bem::LatticePressureOperator op(plan, green); });
}

void green_values() {
  const green::GreenTable green = green_table();
  std::vector<double> distance(100000);
  for (std::size_t i = 0; i < distance.size(); ++i) distance[i] = 0.01 + 0.0129 * double(i);
  std::vector<Complex> value(distance.size());
  guarded([&] { green.evaluate(distance, value); });
}

void gmres() {
  const mesh::Q8Mesh mesh = rectangle(50);
  const green::GreenTable green = green_table();
  const bem::LatticePressureOperator op(std::make_shared<const bem::LatticePlan>(mesh), green);
  const bem::DampedWavePreconditioner preconditioner(mesh, green.exact());
  MatXcd b(op.size(), 8), x(op.size(), 8);
  for (Index i = 0; i < op.size(); ++i)
    for (Index j = 0; j < 8; ++j)
      b(i, j) = std::cos(EIGEN_PI * double(j) * (mesh.nodes()(0, i) / 300.0 + 0.5));
  krylov::GmresReport report;
  guarded([&] {
    report = krylov::solve_gmres(op, {.action = &preconditioner}, b, x, {.tolerance = 1e-6});
  });
  std::printf("iterations %ld\napplications %ld\n", static_cast<long>(report.iterations),
              static_cast<long>(report.applications));
}

void dry_modes() {
  const mesh::Q8Mesh mesh = rectangle(20);
  const plate::PlateProperties plate{
      .thickness = 2.0, .youngs_modulus = 1.19e10, .poisson_ratio = 0.13, .density = 256.25};
  guarded([&] { static_cast<void>(plate::dry_modes(mesh, plate, {.count = 12})); });
}

void sea_statistics() {
  constexpr Index kModes = 20, kDirections = 60;
  const auto real = [](Index rows, int seed) {
    return MatXd(columns_for(rows, kModes + seed).rightCols(kModes).real());
  };
  SeaObservation observation;
  observation.quantity = {0};
  observation.derivative = {0};
  observation.points = real(5, 1);
  observation.lines = real(61, 2);
  observation.nodes = real(2000, 3);
  const std::vector<double> omega{0.4, 0.6, 0.8, 1.0, 1.2, 1.4};
  const wave::SeaState sea{
      .name = "synthetic",
      .description = "",
      .partitions = {{wave::Spectrum::bretschneider(2.0, 6.3), wave::Spreading::cosine_power(2.0)}},
      .mean_heading_deg = {0.0, 90.0}};
  guarded([&] {
    SeaStatistics statistics({sea}, std::move(observation), omega, kDirections);
    for (const double w : omega) statistics.add({w, columns_for(kModes, kDirections)});
    static_cast<void>(statistics.results());
  });
}

// The only figure that is a time: an application over FFTW's padded convolution, in turn
void time_of_application() {
  const green::GreenTable green = green_table();
  const bem::LatticePressureOperator op(std::make_shared<const bem::LatticePlan>(rectangle(300)),
                                        green);
  const F1 anchor(301, 61, FFTW_ESTIMATE);
  const MatXcd x = columns_for(op.size(), 1);
  MatXcd y(op.size(), 1);
  std::vector<double> ratio;
  for (int repeat = 0; repeat < 41; ++repeat) {
    const double f1 = anchor.seconds();
    ratio.push_back(seconds_of([&] { op.apply(x, y); }) / f1);
  }
  std::printf("time_ratio %.3f\n", median(ratio));
}

const std::map<std::string, std::function<void()>>& cases() {
  static const std::map<std::string, std::function<void()>> all = {
      {"dry_modes", dry_modes},
      {"gmres", gmres},
      {"green_values", green_values},
      {"lattice_apply", lattice_apply},
      {"lattice_setup", lattice_setup},
      {"multipole_apply", [] { fast_apply(bem::SumEngine::kMultipole); }},
      {"multipole_setup", [] { near_field(bem::SumEngine::kMultipole); }},
      {"near_field_plan", plan_near_field},
      {"pfft_apply", [] { fast_apply(bem::SumEngine::kPfft); }},
      {"pfft_setup", [] { near_field(bem::SumEngine::kPfft); }},
      {"sea_statistics", sea_statistics},
      {"time_of_application", time_of_application},
  };
  return all;
}

}  // namespace
}  // namespace floe::bench

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  const auto& cases = floe::bench::cases();
  if (argc < 2) {
    for (const auto& [name, run] : cases) std::puts(name.c_str());
    return 0;
  }
  const auto found = cases.find(argv[1]);
  if (found == cases.end()) {
    std::fprintf(stderr, "bench_guard: unknown case %s (bench_guard lists them)\n", argv[1]);
    return 2;
  }
  found->second();
  return 0;
}
