// LatticePressureOperator against F1, alternating, medians of CPU time; errors against exact rows
// of the matrix at sampled nodes.

#include "f1.hpp"
#include "figures.hpp"

#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/mesh/rectangle.hpp>

#include <omp.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <string>

namespace {

using namespace floe;

constexpr double kLength = 300.0, kWidth = 60.0, kDepth = 58.5;  // [m]
constexpr double kOmega = 1.01;                                  // [rad/s]
constexpr int kRepeats = 15;

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The elements of a rectangle of nx × ny that `keep` chooses
mesh::Q8Mesh masked(Index nx, Index ny, const std::function<bool(Index, Index)>& keep) {
  const mesh::Q8Mesh full = mesh::make_rectangle(
      {.length = kLength, .width = kWidth, .nx = static_cast<int>(nx), .ny = static_cast<int>(ny)});
  std::vector<Index> kept, number(full.node_count(), -1);
  for (Index e = 0; e < full.element_count(); ++e)
    if (keep(e % nx, e / nx)) kept.push_back(e);
  for (const Index e : kept)
    for (int a = 0; a < 8; ++a) number[full.elements()(a, e)] = 0;
  Index count = 0;
  for (Index& n : number)
    if (n == 0) n = count++;
  Points2 nodes(2, count);
  for (Index node = 0; node < full.node_count(); ++node)
    if (number[node] >= 0) nodes.col(number[node]) = full.nodes().col(node);
  mesh::Connectivity elements(8, static_cast<Index>(kept.size()));
  for (std::size_t e = 0; e < kept.size(); ++e)
    for (int a = 0; a < 8; ++a)
      elements(a, static_cast<Index>(e)) = number[full.elements()(a, kept[e])];
  return {std::move(nodes), std::move(elements)};
}

// Error at 20 nodes, first and last among them, relative to the mean square there
double sampled_error(const mesh::Q8Mesh& mesh, const green::GreenTable& green, const MatXcd& x,
                     const MatXcd& y) {
  const bem::ElementIntegrals integrals(mesh);
  const double kappa = green.exact().nu() / (4.0 * std::numbers::pi);
  double error = 0.0, norm = 0.0;
  constexpr int kSamples = 20;
#pragma omp parallel for schedule(dynamic, 1) reduction(+ : error, norm)
  for (int sample = 0; sample < kSamples; ++sample) {
    const Index node = (mesh.node_count() - 1) * sample / (kSamples - 1);
    VecXcd row(mesh.node_count());
    integrals.node_row(node, green, row);
    const Complex exact = x(node, 0) + kappa * (row.transpose() * x.col(0))(0, 0);
    error += std::norm(y(node, 0) - exact);
    norm += std::norm(exact);
  }
  return std::sqrt(error / norm);
}

bench::Figures compare(Index nx, Index ny, const mesh::Q8Mesh& mesh) {
  const green::GreenFunction exact(kOmega * kOmega / 9.81, kDepth);
  const green::GreenTable green(exact, 1.1 * std::hypot(kLength, kWidth));
  std::shared_ptr<const bem::LatticePlan> plan;
  const double plan_time = bench::seconds_of(
      [&] { plan = std::make_shared<const bem::LatticePlan>(mesh, bem::IntegralOptions{}); });
  std::unique_ptr<const bem::LatticePressureOperator> op;
  std::vector<double> setup, one, four, f1, f1_estimate, wall;
  for (int repeat = 0; repeat < 3; ++repeat)
    setup.push_back(bench::seconds_of(
        [&] { op = std::make_unique<const bem::LatticePressureOperator>(plan, green); }));

  const Index count = mesh.node_count();
  MatXcd x = MatXcd::Random(count, 4), y(count, 4), block(count, 4);
  const bench::F1 estimated(nx + 1, ny + 1, FFTW_ESTIMATE), measured(nx + 1, ny + 1, FFTW_MEASURE);
  fftw_forget_wisdom();  // or estimated plans of the next case would make use of it
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    f1.push_back(measured.seconds());
    f1_estimate.push_back(estimated.seconds());
    const double start = wall_seconds();
    one.push_back(bench::seconds_of([&] { op->apply(x.col(0), y.col(0)); }));
    wall.push_back(wall_seconds() - start);
    four.push_back(0.25 * bench::seconds_of([&] { op->apply(x, block); }));
  }
  const double time = bench::median(one), anchor = bench::median(f1);
  return {.nodes = static_cast<double>(count),
          .seconds = time,
          .anchor = anchor,
          .error = sampled_error(mesh, green, x, y),
          .bytes = op->memory() + plan->memory(),
          .more = {{"wall_s", bench::median(wall)},
                   {"ratio_estimate", time / bench::median(f1_estimate)},
                   {"of_four_ratio", bench::median(four) / anchor},
                   {"plan_applications", plan_time / time},
                   {"setup_applications", bench::median(setup) / time}}};
}

using Keep = std::function<bool(Index, Index)>;

void add(const char* id, const char* outline, Index nx, const Keep& keep) {
  const char* const full = nx > 1000 ? "/full" : "";
  bench::add_measurement(
      std::string(id) + "/lattice/" + outline + "/nx=" + std::to_string(nx) + full,
      [=] { return compare(nx, nx / 5, masked(nx, nx / 5, keep)); });
}

}  // namespace

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  for (const Index nx : {690, 1290}) {
    const Index ny = nx / 5;
    add("T1", "rectangle", nx, [](Index, Index) { return true; });
    add("T1", "L", nx, [=](Index i, Index j) { return 2 * i < nx || 2 * j < ny; });
    add("T1", "hole", nx, [=](Index i, Index j) {
      return 3 * i < nx || 3 * i >= 2 * nx || 3 * j < ny || 3 * j >= 2 * ny;
    });
    add("T1", "staircase", nx, [=](Index i, Index j) {
      return 4.0 * std::hypot((double(i) + 0.5) / double(nx) - 0.5,
                              (double(j) + 0.5) / double(ny) - 0.5) <
             2.0;
    });
  }
  return bench::run_measurements(argc, argv);
}
