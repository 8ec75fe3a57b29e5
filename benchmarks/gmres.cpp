// Block GMRES on the lattice operator: iterations and applications a mode for the outlines and
// wavelengths of docs/theory/solver.md. Five elements a wavelength, 30 columns; the error is
// the true residual.

#include "figures.hpp"

#include <floe/bem/coarse_preconditioner.hpp>
#include <floe/bem/damped_wave_preconditioner.hpp>
#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/krylov/gmres.hpp>

#include <lattice_mesh.hpp>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
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

enum class Preconditioning { none, damped, damped_single, coarse };

bench::Figures measure(const Case& c, Preconditioning kind, double elements_per_wavelength) {
  constexpr Index kColumns = 30;
  using Basis = krylov::GmresOptions::Basis;
  const double k = c.kl / kLength, nu = std::isinf(c.kh) ? k : k * std::tanh(c.kh);
  const mesh::Q8Mesh mesh = make_mesh(c, elements_per_wavelength);
  const green::GreenTable green(green::GreenFunction(nu, c.kh / k), 1.6 * kLength);
  const bem::LatticePressureOperator a(std::make_shared<const bem::LatticePlan>(mesh), green);
  const MatXcd b = test::smooth_modes(mesh, kColumns);
  const double start = omp_get_wtime();
  std::unique_ptr<const krylov::LinearOperator> preconditioner;
  if (kind == Preconditioning::coarse)
    preconditioner = std::make_unique<const bem::CoarsePreconditioner>(mesh, green);
  else if (kind != Preconditioning::none)
    preconditioner = std::make_unique<const bem::DampedWavePreconditioner>(mesh, green.exact());
  const double setup = omp_get_wtime() - start;
  MatXcd x(b.rows(), b.cols());
  const bool single = kind == Preconditioning::damped_single;
  const krylov::GmresReport r =
      krylov::solve_gmres(a, {.action = preconditioner.get()}, b, x,
                          {.basis = single ? Basis::single_precision : Basis::double_precision});
  return {.nodes = static_cast<double>(b.rows()),
          .tolerance = krylov::GmresOptions{}.tolerance,
          .seconds = omp_get_wtime() - start - setup,
          .error = r.true_residual.maxCoeff(),
          .bytes = 16.0 * static_cast<double>(b.rows() * r.iterations),
          .more = {{"steps", static_cast<double>(r.iterations)},
                   {"applications_a_mode", double(r.applications) / double(kColumns)},
                   {"setup_s", setup},
                   {"kL", c.kl},
                   {"kh", c.kh}}};
}

}  // namespace

int main(int argc, char** argv) {
  const auto add = [](const std::string& id, const Case& c, const char* name, Preconditioning kind,
                      double elements) {
    const std::string depth = std::isinf(c.kh) ? "inf" : std::to_string(c.kh).substr(0, 3);
    const bool quick =
        kind == Preconditioning::damped || (kind == Preconditioning::none && c.kl < 100.0);
    bench::add_measurement(id + "/gmres_wall/" + c.outline + "/kL=" + std::to_string(int(c.kl)) +
                               "/kh=" + depth + "/" + name + (quick ? "" : "/full"),
                           [=] { return measure(c, kind, elements); });
  };
  for (const Case& c : {Case{"rectangle", 31.0, kDeep}, Case{"rectangle", 122.0, kDeep},
                        Case{"rectangle", 240.0, kDeep}, Case{"rectangle", 122.0, 1.0},
                        Case{"rectangle", 122.0, 0.1}, Case{"L", 122.0, 1.0},
                        Case{"ring", 122.0, 1.0}, Case{"gap", 122.0, 1.0}}) {
    const std::string id = std::isinf(c.kh) ? "T9" : c.kh == 1.0 ? "T9b" : "gmres";
    add(id, c, "damped", Preconditioning::damped, 5.0);
    add(id, c, "damped_single", Preconditioning::damped_single, 5.0);
    add(id, c, "coarse", Preconditioning::coarse, 5.0);
    if (c.outline == "rectangle" && c.kl < 200.0) add(id, c, "none", Preconditioning::none, 5.0);
  }
  return bench::run_measurements(argc, argv);
}
