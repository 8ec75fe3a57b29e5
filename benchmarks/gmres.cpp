// Block GMRES on the lattice operator: iterations and applications a mode for the outlines and
// wavelengths of docs/theory/solver.md. Arguments, all optional: an outline (or all), elements a
// wavelength, columns.

#include <floe/bem/coarse_preconditioner.hpp>
#include <floe/bem/damped_wave_preconditioner.hpp>
#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/krylov/gmres.hpp>
#include <floe/numeric/error.hpp>

#include <lattice_mesh.hpp>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

namespace {

using namespace floe;

constexpr double kLength = 1000.0;
constexpr double kDeep = std::numeric_limits<double>::infinity();

struct Case {
  std::string outline;
  double kl, kh;
};

// Longer side kLength; rectangle and gap 5:1, arms of the L 1/3, wall of the ring 1/5, the gap two
// elements wide
mesh::Q8Mesh make_mesh(const Case& c, double elements_per_wavelength) {
  const int nx = 10 * int(std::ceil(c.kl / (20.0 * EIGEN_PI) * elements_per_wavelength));
  const bool square = c.outline == "L" || c.outline == "ring";
  const int ny = square ? nx : nx / 5;
  const double e = kLength / nx;
  return test::lattice_mesh(nx, ny, e, e, [&](int i, int j) {
    if (c.outline == "L") return i < nx / 3 || j < nx / 3;
    if (c.outline == "ring") return std::min({i, j, nx - 1 - i, nx - 1 - j}) < nx / 5;
    if (c.outline == "gap") return i < nx / 2 - 1 || i > nx / 2;
    return true;
  });
}

struct Run {
  const char* name;
  const krylov::LinearOperator* preconditioner;
  double setup;
  krylov::GmresOptions::Basis basis;
};

void report(const Case& c, const bem::LatticePressureOperator& a, const MatXcd& b, const Run& run) {
  MatXcd x(b.rows(), b.cols());
  const double start = omp_get_wtime();
  try {
    const krylov::GmresReport r =
        krylov::solve_gmres(a, {.action = run.preconditioner}, b, x, {.basis = run.basis});
    std::printf(
        "%-9s kL %5.0f kh %4g N %7td %-13s %s block %2td iterations %3td cycles %td "
        "applications a mode %5.1f setup %.2f s solve %.2f s threads %d residual %.1e\n",
        c.outline.c_str(), c.kl, c.kh, b.rows(), run.name,
        run.basis == krylov::GmresOptions::Basis::double_precision ? "double" : "single",
        r.block_size, r.iterations, r.cycles, double(r.applications) / double(b.cols()), run.setup,
        omp_get_wtime() - start, omp_get_max_threads(), r.true_residual.maxCoeff());
  } catch (const Error& error) {
    std::printf("%-9s kL %5.0f kh %4g N %7td %-13s %s\n", c.outline.c_str(), c.kl, c.kh, b.rows(),
                run.name, error.what());
  }
  std::fflush(stdout);
}

void run_case(const Case& c, double elements_per_wavelength, Index columns) {
  const double k = c.kl / kLength, nu = std::isinf(c.kh) ? k : k * std::tanh(c.kh);
  const mesh::Q8Mesh mesh = make_mesh(c, elements_per_wavelength);
  const green::GreenTable green(green::GreenFunction(nu, c.kh / k), 1.6 * kLength);
  const bem::LatticePressureOperator a(std::make_shared<const bem::LatticePlan>(mesh), green);
  const MatXcd b = test::smooth_modes(mesh, columns);
  const double start = omp_get_wtime();
  const bem::DampedWavePreconditioner wave(mesh, green.exact());
  const double middle = omp_get_wtime();
  const bem::CoarsePreconditioner coarse(mesh, green);
  const double end = omp_get_wtime();
  using Basis = krylov::GmresOptions::Basis;
  if (c.outline == "rectangle" && c.kh == kDeep && c.kl < 200.0)
    report(c, a, b, {"none", nullptr, 0.0, Basis::double_precision});
  report(c, a, b, {"damped wave", &wave, middle - start, Basis::double_precision});
  report(c, a, b, {"damped wave", &wave, middle - start, Basis::single_precision});
  if (coarse.points_per_wavelength() < 4.0) return;  // too coarse to be of use
  char name[32];
  std::snprintf(name, sizeof name, "coarse (%.1f)", coarse.points_per_wavelength());
  report(c, a, b, {name, &coarse, end - middle, Basis::double_precision});
}

}  // namespace

int main(int argc, char** argv) {
  const std::string outline = argc > 1 ? argv[1] : "all";
  const double elements_per_wavelength = argc > 2 ? std::atof(argv[2]) : 8.0;
  const Index columns = argc > 3 ? std::atol(argv[3]) : 30;
  for (const Case& c : {Case{"rectangle", 31.0, kDeep}, Case{"rectangle", 122.0, kDeep},
                        Case{"rectangle", 240.0, kDeep}, Case{"rectangle", 122.0, 1.0},
                        Case{"rectangle", 122.0, 0.1}, Case{"L", 122.0, 1.0},
                        Case{"ring", 122.0, 1.0}, Case{"gap", 122.0, 1.0}})
    if (outline == "all" || outline == c.outline) run_case(c, elements_per_wavelength, columns);
}
