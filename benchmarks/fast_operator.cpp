// The pressure operator on a general mesh: time of an application in F1, set-up, bytes a node, and
// the error against exact rows, for both engines.
#include "curved_plate.hpp"
#include "f1.hpp"
#include "figures.hpp"

#include <floe/bem/fast_pressure_operator.hpp>

#include <omp.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace floe::bench {
namespace {

constexpr double kDepth = 58.5, kOmega = 1.01, kGravity = 9.81;

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

Figures measure(int nx, bem::SumEngine engine, double tolerance) {
  const mesh::Q8Mesh mesh = curved_plate(nx);
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
  return {.nodes = nodes,
          .tolerance = tolerance,
          .seconds = t1,
          .anchor = f,
          .error = sampled_error(mesh, green, x.values, y, 0),
          .bytes = op->memory() + plan->memory(),
          .more = {{"error_wave", sampled_error(mesh, green, x.values, y, 1)},
                   {"of_eight_s", t8},
                   {"of_eight_share", t8 / t1},
                   {"plan_s", plan_time},
                   {"setup_applications", setup / t1},
                   {"operator_bytes", op->memory()}}};
}

}  // namespace
}  // namespace floe::bench

int main(int argc, char** argv) {
  using namespace floe::bench;
  using floe::bem::SumEngine;
  omp_set_num_threads(1);
  for (const auto& [id, tolerance] : {std::pair{"T2", 1e-4}, std::pair{"T3", 1e-6}}) {
    const std::string end = "/nx=690/tolerance=" + std::string(tolerance > 1e-5 ? "1e-4" : "1e-6");
    add_measurement(id + std::string("/pfft_operator") + end,
                    [=] { return measure(690, SumEngine::kPfft, tolerance); });
    add_measurement("fmm_operator" + end,
                    [=] { return measure(690, SumEngine::kMultipole, tolerance); });
  }
  return run_measurements(argc, argv);
}
