// The fluid of the paper's case at one frequency, 30 modes, every heading (T7): geometry, table of
// the Green function, operator, preconditioner, radiation and exciting forces to 1e-6, CPU time on
// one thread, in turn with LAPACK's LU factors of a full matrix of that size. Basis in single
// precision, as `floe run` has it on a lattice.
#include "f1.hpp"
#include "figures.hpp"

#include <floe/bem/damped_wave_preconditioner.hpp>
#include <floe/bem/iterative_pressure_operator.hpp>
#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/hydro/radiation.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/blas_threads.hpp>
#include <floe/plate/dry_modes.hpp>
#include <floe/plate/mindlin.hpp>

#include <complex>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

extern "C" void zgetrf_(const int*, const int*, std::complex<double>*, const int*, int*, int*);

namespace floe::bench {
namespace {

constexpr double kOmega = 1.01, kNu = kOmega * kOmega / 9.81;
constexpr wave::Water kWater{.depth = 58.5, .density = 1025.0, .gravity = 9.81};
constexpr double kTolerance = 1e-6;

hydro::Radiation solve_fluid(const mesh::Q8Mesh& mesh, const MatXd& deflection) {
  const auto plan = std::make_shared<const bem::LatticePlan>(mesh);
  const SparseMatrix surface_mass = hydro::surface_mass(mesh);
  const green::GreenTable green(green::GreenFunction(kNu, kWater.depth),
                                1.01 * (mesh.upper() - mesh.lower()).norm());
  krylov::GmresOptions options;
  options.tolerance = kTolerance;
  options.basis = krylov::GmresOptions::Basis::single_precision;
  const bem::IterativePressureOperator pressure_operator(
      std::make_unique<const bem::LatticePressureOperator>(plan, green), nullptr,
      std::make_unique<const bem::DampedWavePreconditioner>(mesh, green.exact()), options,
      "lattice");
  hydro::Radiation radiation = hydro::solve_radiation(pressure_operator, deflection, surface_mass,
                                                      kOmega, kWater, kTolerance);
  std::vector<double> heading;
  for (int i = 0; i < 7; ++i) heading.push_back(std::numbers::pi / 12.0 * i);
  const MatXcd forces = hydro::exciting_forces(
      radiation.pressure, hydro::wave_loads(mesh, green.exact().wavenumber(), heading));
  ::benchmark::DoNotOptimize(forces.data());
  return radiation;
}

double factorisation_seconds(const MatXcd& random) {
  MatXcd matrix = random;
  const int n = static_cast<int>(matrix.rows());
  std::vector<int> pivots(static_cast<std::size_t>(n));
  int info = 0;
  return seconds_of([&] { zgetrf_(&n, &n, matrix.data(), &n, pivots.data(), &info); });
}

Figures measure(int nx, int repeats) {
  omp_set_num_threads(1);
  numeric::use_one_blas_thread();
  const mesh::Q8Mesh mesh =
      mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = nx, .ny = nx / 5});
  const plate::PlateProperties properties{
      .thickness = 2.0, .youngs_modulus = 1.19e10, .poisson_ratio = 0.13, .density = 256.25};
  const plate::DryModes modes = plate::dry_modes(mesh, properties);
  const MatXd deflection =
      modes.shape(Eigen::seq(0, Eigen::last, plate::kUnknownsPerNode), Eigen::all);
  const MatXcd matrix = MatXcd::Random(mesh.node_count(), mesh.node_count());
  std::vector<double> fluid, factorisation, ratio;
  hydro::Radiation radiation;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    fluid.push_back(seconds_of([&] { radiation = solve_fluid(mesh, deflection); }));
    factorisation.push_back(factorisation_seconds(matrix));
    ratio.push_back(factorisation.back() / fluid.back());
  }
  return {.nodes = static_cast<double>(mesh.node_count()),
          .tolerance = kTolerance,
          .seconds = median(fluid),
          .anchor = median(factorisation),
          .error = radiation.true_residual,
          .bytes = 0.0,
          .more = {{"factor", median(ratio)},
                   {"gmres_steps", static_cast<double>(radiation.work.iterations)}}};
}

}  // namespace
}  // namespace floe::bench

int main(int argc, char** argv) {
  using namespace floe;
  bench::add_measurement("T7/fluid/nx=50", [] { return bench::measure(50, 25); });
  bench::add_measurement("T7/fluid/nx=75", [] { return bench::measure(75, 3); });
  bench::add_measurement("T7/fluid/nx=120/full", [] { return bench::measure(120, 1); });
  return bench::run_measurements(argc, argv);
}
