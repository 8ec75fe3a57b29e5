#include <floe/bem/coarse_preconditioner.hpp>
#include <floe/bem/damped_wave_preconditioner.hpp>
#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/krylov/gmres.hpp>
#include <floe/mesh/rectangle.hpp>

#include <expect.hpp>
#include <gtest/gtest.h>
#include <lattice_mesh.hpp>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace floe::bem {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Elements of unequal size, turned and sheared, curved a little
mesh::Q8Mesh unstructured(double length, double width, int nx, int ny) {
  const mesh::Q8Mesh graded =
      mesh::make_rectangle({.length = length, .width = width, .nx = nx, .ny = ny, .grading = 3.0});
  Points2 nodes = graded.nodes();
  for (Index i = 0; i < nodes.cols(); ++i) {
    const double x = nodes(0, i), y = nodes(1, i);
    nodes.col(i) = Point2(0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y) +
                   0.02 * width * Point2(std::sin(9.0 * y / width), std::cos(5.0 * x / width));
  }
  return {nodes, graded.elements()};
}

struct Setting {
  mesh::Q8Mesh mesh;
  double wavenumber, depth;
  green::GreenTable green() const {
    const double nu = std::isinf(depth) ? wavenumber : wavenumber * std::tanh(wavenumber * depth);
    return {green::GreenFunction(nu, depth), 2.0 * mesh.size()};
  }
};

krylov::GmresReport solve(const krylov::LinearOperator& a, const krylov::LinearOperator* m,
                          const MatXcd& b, MatXcd& x, double tolerance = 1e-6) {
  x.resize(b.rows(), b.cols());
  return krylov::solve_gmres(a, {.action = m}, b, x, {.tolerance = tolerance});
}

TEST(twin_Preconditioners, LeadToTheSolutionOfTheDenseFactorsOnAnyMesh) {
  for (const double depth : {kInfinity, 10.0, 2.0}) {
    const Setting setting{unstructured(100.0, 40.0, 20, 8), 0.3, depth};
    const green::GreenTable green = setting.green();
    const ElementIntegrals integrals(setting.mesh);
    const DensePressureOperator dense(integrals, green);
    const DampedWavePreconditioner wave(setting.mesh, green.exact());
    const CoarsePreconditioner coarse(setting.mesh, green);
    const MatXcd b = test::smooth_modes(setting.mesh, 4);
    MatXcd expected = b, with_wave, with_coarse;
    dense.solve(expected);
    const Index damped = solve(dense, &wave, b, with_wave, 1e-9).applications;
    const Index two_grid = solve(dense, &coarse, b, with_coarse, 1e-9).applications;
    // A has no small eigenvalues but for long waves in shallow water: 1e3 is plenty
    for (const MatXcd* x : {&with_wave, &with_coarse})
      EXPECT_LE(test::relative_error(*x, expected), 1e3 * 1e-9) << "depth " << depth;
    // The whole space has 137 directions a mode
    EXPECT_LT(damped, 4 * 40) << "depth " << depth;
    EXPECT_LT(two_grid, damped) << "depth " << depth;
  }
}

TEST(DampedWavePreconditioner, DoesNotDependOnTheMeshMuchNorOnItsPosition) {
  // The same plate with other elements, and turned by a right angle: it acts on smooth fields alike
  const double k = 0.4;
  const green::GreenFunction green(k, kInfinity);
  const auto mean_of = [&](const mesh::Q8Mesh& mesh) {
    const DampedWavePreconditioner m(mesh, green);
    const MatXcd one = MatXcd::Ones(mesh.node_count(), 1);
    MatXcd y(mesh.node_count(), 1);
    m.apply(one, y);
    Complex middle = 0.0;
    double nearest = kInfinity;
    const Point2 centre = 0.5 * (mesh.lower() + mesh.upper());
    for (Index i = 0; i < mesh.node_count(); ++i)
      if ((mesh.nodes().col(i) - centre).norm() < nearest) {
        nearest = (mesh.nodes().col(i) - centre).norm();
        middle = y(i, 0);
      }
    return middle;
  };
  const Complex wide =
      mean_of(mesh::make_rectangle({.length = 80, .width = 32, .nx = 40, .ny = 16}));
  const Complex tall =
      mean_of(mesh::make_rectangle({.length = 32, .width = 80, .nx = 16, .ny = 40}));
  const Complex graded = mean_of(
      mesh::make_rectangle({.length = 80, .width = 32, .nx = 40, .ny = 16, .grading = 2.0}));
  EXPECT_LE(std::abs(wide - tall), 1e-12 * std::abs(wide));
  // Interpolation at eight points a wavelength
  EXPECT_LE(std::abs(wide - graded), 1e-2 * std::abs(wide));
}

TEST(DampedWavePreconditioner, FindsTheWidthOfTheOutline) {
  const green::GreenFunction green(0.3, kInfinity);
  const auto width_of = [&](int nx, int ny, const std::function<bool(int, int)>& keep) {
    return DampedWavePreconditioner(test::lattice_mesh(nx, ny, 1.0, 1.0, keep), green).width();
  };
  // To a cell of the grid, 2.6 m; where arms meet, the widest circle is 1.17 times as wide
  EXPECT_NEAR(width_of(100, 20, [](int, int) { return true; }), 20.0, 2.7);
  EXPECT_NEAR(width_of(60, 60, [](int i, int j) { return i < 20 || j < 20; }), 23.4, 2.7);
  EXPECT_NEAR(
      width_of(80, 80,
               [](int i, int j) { return std::abs(2 * i - 79) > 40 || std::abs(2 * j - 79) > 40; }),
      23.4, 2.7);
  EXPECT_NEAR(width_of(102, 20, [](int i, int) { return i != 50 && i != 51; }), 20.0, 2.7);
}

// Applications a mode for 30 modes to 1e-6: the numbers of docs/theory/solver.md, on fewer elements
struct Bound {
  const char* name;
  double kl, kh;
  int nx, ny;
  std::function<bool(int, int)> keep;
  double wave, coarse;  // at most
};

TEST(Preconditioners, KeepIterationsFew) {
  const auto all = [](int, int) { return true; };
  const auto ring = [](int i, int j) { return std::min({i, j, 39 - i, 39 - j}) < 8; };
  const std::vector<Bound> bounds{
      {"rectangle", 31.0, kInfinity, 40, 8, all, 8.5, 7.5},
      {"rectangle", 60.0, kInfinity, 60, 12, all, 12.0, 10.0},
      {"rectangle", 60.0, 1.0, 60, 12, all, 13.0, 10.0},
      {"L", 40.0, 1.0, 36, 36, [](int i, int j) { return i < 12 || j < 12; }, 12.0, 9.0},
      {"ring", 40.0, 1.0, 40, 40, ring, 15.0, 10.0},
      {"gap", 60.0, 1.0, 62, 12, [](int i, int) { return i != 30 && i != 31; }, 14.0, 10.0}};
  for (const Bound& c : bounds) {
    const double step = 100.0 / c.nx, k = c.kl / 100.0;
    const Setting setting{test::lattice_mesh(c.nx, c.ny, step, step, c.keep), k, c.kh / k};
    const green::GreenTable green = setting.green();
    const LatticePressureOperator a(std::make_shared<const LatticePlan>(setting.mesh), green);
    const DampedWavePreconditioner wave(setting.mesh, green.exact());
    const CoarsePreconditioner coarse(setting.mesh, green);
    const MatXcd b = test::smooth_modes(setting.mesh, 30);
    MatXcd x;
    EXPECT_LE(double(solve(a, &wave, b, x).applications) / 30.0, c.wave) << c.name;
    EXPECT_LE(double(solve(a, &coarse, b, x).applications) / 30.0, c.coarse) << c.name;
  }
}

TEST(Preconditioners, HaveTheSameBitsForAnyNumberOfThreads) {
  const Setting setting{unstructured(60.0, 30.0, 14, 7), 0.5, 10.0};
  const green::GreenTable green = setting.green();
  const MatXcd x = test::smooth_modes(setting.mesh, 3);
  const int before = omp_get_max_threads();
  MatXcd first_wave, first_coarse;
  for (const int threads : {1, 2, 3, 7}) {
    omp_set_num_threads(threads);
    MatXcd wave(x.rows(), 3), coarse(x.rows(), 3);
    DampedWavePreconditioner(setting.mesh, green.exact()).apply(x, wave);
    CoarsePreconditioner(setting.mesh, green).apply(x, coarse);
    if (threads == 1) first_wave = wave, first_coarse = coarse;
    EXPECT_EQ(first_wave, wave) << threads << " threads";
    EXPECT_EQ(first_coarse, coarse) << threads << " threads";
  }
  omp_set_num_threads(before);
}

}  // namespace
}  // namespace floe::bem
