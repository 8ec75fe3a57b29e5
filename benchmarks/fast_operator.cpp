// The pressure operator on a general mesh: time of an application in F1, set-up, bytes a node, and
// the error against exact rows, for both engines.
//   bench_fast_operator [elements along the plate = 690] [tolerance …]
#include "f1.hpp"

#include <floe/bem/fast_pressure_operator.hpp>
#include <floe/mesh/rectangle.hpp>

#include <omp.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace floe::benchmark {
namespace {

constexpr double kDepth = 58.5, kOmega = 1.01, kGravity = 9.81;

// A 5 : 1 plate whose elements all differ: edges curved by a smooth map
mesh::Q8Mesh curved_plate(int nx) {
  const mesh::Q8Mesh plain =
      mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = nx, .ny = nx / 5});
  Points2 nodes = plain.nodes();
  for (Index i = 0; i < nodes.cols(); ++i) {
    const double x = nodes(0, i), y = nodes(1, i);
    nodes(0, i) += 1.5 * std::sin(y / 11.0) + 2.0 * std::sin(x / 37.0);
    nodes(1, i) += 1.0 * std::sin(x / 23.0) + 0.7 * std::sin(y / 9.0 + x / 50.0);
  }
  return {nodes, plain.elements()};
}

struct Columns {
  MatXcd values;
  Columns(const mesh::Q8Mesh& mesh, double wavenumber) : values(mesh.node_count(), 8) {
    values.setRandom();
    for (Index i = 0; i < mesh.node_count(); ++i)
      values(i, 1) = std::polar(1.0, wavenumber * mesh.nodes()(0, i) * 0.8);
  }
};

// Relative error of 𝒢p at sampled nodes
double sampled_error(const mesh::Q8Mesh& mesh, const green::GreenTable& green, const MatXcd& x,
                     const MatXcd& y, Index column) {
  const bem::ElementIntegrals integrals(mesh, {.tolerance = 1e-10});
  const double kappa = green.exact().nu() / (4.0 * std::numbers::pi);
  constexpr int kSamples = 24;
  double error = 0.0, norm = 0.0;
#pragma omp parallel for reduction(+ : error, norm)
  for (int s = 0; s < kSamples; ++s) {
    const Index node = (2 * s + 1) * mesh.node_count() / (2 * kSamples);
    VecXcd row(mesh.node_count());
    integrals.node_row(node, green, row);
    const Complex exact = kappa * row.cwiseProduct(x.col(column)).sum();
    error += std::norm(y(node, column) - x(node, column) - exact);
    norm += std::norm(exact);
  }
  return std::sqrt(error / norm);
}

void measure(const mesh::Q8Mesh& mesh, int nx, bem::SumEngine engine, double tolerance) {
  const double nu = kOmega * kOmega / kGravity;
  const green::GreenFunction exact(nu, kDepth);
  std::shared_ptr<const bem::FastPressurePlan> plan;
  const double plan_time = seconds_of([&] {
    plan = std::make_shared<const bem::FastPressurePlan>(
        mesh, bem::FastOptions{
                  .engine = engine, .tolerance = tolerance, .max_wavenumber = exact.wavenumber()});
  });
  const green::GreenTable green(exact, plan->reach());
  std::unique_ptr<const bem::FastPressureOperator> op;
  const double setup =
      seconds_of([&] { op = std::make_unique<const bem::FastPressureOperator>(plan, green); });

  const Columns x(mesh, exact.wavenumber());
  MatXcd y(x.values.rows(), 8);
  const F1 anchor(nx, nx / 5, FFTW_MEASURE);
  std::vector<double> one, eight, f1;
  for (int repeat = 0; repeat < 5; ++repeat) {
    f1.push_back(anchor.seconds());
    one.push_back(seconds_of([&] { op->apply(x.values.leftCols(1), y.leftCols(1)); }));
    eight.push_back(seconds_of([&] { op->apply(x.values, y); }));
  }
  const double t1 = median(one), t8 = median(eight) / 8.0, f = median(f1);
  const double nodes = static_cast<double>(mesh.node_count());
  std::printf(
      "%-10s N %ld threads %d tolerance %.0e error random %.1e wave %.1e one %.1f ms %.2f F1 "
      "eight %.1f ms a column %.2f F1 ratio %.2f setup %.2f s %.0f applications plan %.2f s "
      "bytes a node: operator %.0f plan %.0f F1 %.1f ms\n",
      engine == bem::SumEngine::kPfft ? "pfft" : "multipole", static_cast<long>(mesh.node_count()),
      omp_get_max_threads(), tolerance, sampled_error(mesh, green, x.values, y, 0),
      sampled_error(mesh, green, x.values, y, 1), 1e3 * t1, t1 / f, 1e3 * t8, t8 / f, t8 / t1,
      setup, setup / t1, plan_time, op->memory() / nodes, plan->memory() / nodes, 1e3 * f);
  std::fflush(stdout);
}

}  // namespace
}  // namespace floe::benchmark

int main(int argc, char** argv) {
  using namespace floe;
  const int nx = argc > 1 ? std::atoi(argv[1]) : 690;
  const mesh::Q8Mesh mesh = benchmark::curved_plate(nx);
  std::vector<double> tolerances;
  for (int i = 2; i < argc; ++i) tolerances.push_back(std::atof(argv[i]));
  if (tolerances.empty()) tolerances = {1e-3, 1e-4, 1e-6};
  for (const double tolerance : tolerances)
    for (const bem::SumEngine engine : {bem::SumEngine::kPfft, bem::SumEngine::kMultipole})
      benchmark::measure(mesh, nx, engine, tolerance);
}
