#include "test_paths.hpp"

#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/bem/fast_pressure_operator.hpp>
#include <floe/bem/lattice_pressure_operator.hpp>
#include <floe/mesh/mesh_file.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/numeric/error.hpp>

#include <expect.hpp>
#include <gtest/gtest.h>
#include <lattice_mesh.hpp>
#include <omp.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace floe::bem {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNu = 0.104;  // 1.01 rad/s

const char* name_of(SumEngine engine) {
  return engine == SumEngine::kDirect ? "direct" : engine == SumEngine::kPfft ? "pfft" : "fmm";
}

mesh::Q8Mesh read(const std::string& name) {
  return mesh::read_mesh(std::filesystem::path(FLOE_SOURCE_DIR) / "meshes" / name).mesh;
}

// Worst case and the usual one: no order at all, and a wave
MatXcd test_columns(const mesh::Q8Mesh& mesh, double wavenumber) {
  MatXcd x = MatXcd::Random(mesh.node_count(), 2);
  for (Index i = 0; i < x.rows(); ++i)
    x(i, 1) = std::polar(1.0, wavenumber * (0.8 * mesh.nodes()(0, i) + 0.6 * mesh.nodes()(1, i)));
  return x;
}

// ‖(A - A*) p‖ / ‖𝒢* p‖, relative to what the engine had to compute, not to p
void expect_agreement(const std::string& name, const mesh::Q8Mesh& mesh, double depth,
                      const std::vector<double>& tolerances, double nu = kNu) {
  const green::GreenFunction exact(nu, depth);
  const green::GreenTable green(exact, 4.0 * (mesh.upper() - mesh.lower()).norm());
  const MatXcd x = test_columns(mesh, exact.wavenumber());
  MatXcd expected(x.rows(), 2), actual(x.rows(), 2);
  DensePressureOperator(ElementIntegrals(mesh, {.tolerance = 1e-11}), green).apply(x, expected);
  for (const double tolerance : tolerances)
    for (const SumEngine engine : {SumEngine::kDirect, SumEngine::kPfft, SumEngine::kMultipole}) {
      const auto plan = std::make_shared<const FastPressurePlan>(
          mesh,
          FastOptions{
              .engine = engine, .tolerance = tolerance, .max_wavenumber = exact.wavenumber()});
      FastPressureOperator(plan, green).apply(x, actual);
      for (Index column = 0; column < 2; ++column) {
        const double error = (actual.col(column) - expected.col(column)).norm() /
                             (expected.col(column) - x.col(column)).norm();
        EXPECT_LE(error, 10.0 * tolerance)
            << name << ", " << name_of(engine) << ", depth " << depth << ", column " << column;
      }
    }
}

const std::vector<double> kTolerances{1e-3, 1e-5, 1e-7};

TEST(twin_FastPressureOperator, EqualsTheDenseOperatorOnEqualElements) {
  const auto rectangle = test::lattice_mesh(20, 6, 3.0, 2.0, [](int, int) { return true; });
  const auto bent =
      test::lattice_mesh(12, 9, 3.0, 2.0, [](int i, int j) { return i < 4 || j < 3; });
  const auto hole = test::lattice_mesh(
      12, 9, 3.0, 2.0, [](int i, int j) { return i < 4 || i > 7 || j < 3 || j > 5; });
  const auto two = test::lattice_mesh(19, 5, 3.0, 2.0, [](int i, int) { return i < 8 || i > 10; });
  expect_agreement("rectangle", rectangle, 58.5, kTolerances);
  expect_agreement("L", bent, 58.5, kTolerances);
  expect_agreement("hole", hole, 58.5, kTolerances);
  expect_agreement("two plates", two, 58.5, kTolerances);
}

TEST(twin_FastPressureOperator, EqualsTheDenseOperatorOnACurvedUnstructuredMesh) {
  expect_agreement("disc", read("disc.msh"), 58.5, kTolerances);
}

TEST(twin_FastPressureOperator, EqualsTheDenseOperatorOnAGradedMesh) {
  const auto graded =
      mesh::make_rectangle({.length = 120.0, .width = 40.0, .nx = 22, .ny = 10, .grading = 20.0});
  expect_agreement("graded", graded, 58.5, kTolerances);
}

TEST(twin_FastPressureOperator, EqualsTheDenseOperatorAtEveryDepth) {
  for (const double depth : {1.0, 10.0, kInfinity})
    expect_agreement("ring", read("ring.msh"), depth, {1e-4, 1e-6});
}

TEST(twin_FastPressureOperator, EqualsTheDenseOperatorAtFourNodesAWavelength) {
  const auto plate = test::lattice_mesh(20, 6, 3.0, 2.0, [](int, int) { return true; });
  expect_agreement("short waves", plate, kInfinity, {1e-4, 1e-6, 1e-7 /* the finest rule */},
                   2.0 * std::numbers::pi / 6.0);
}

TEST(twin_FastPressureOperator, EqualsTheDenseOperatorWhereTheRestOfGIsNotSmooth) {
  // Elements 30 times as long as the water is deep, where moments do not do; and waves of three
  // elements' length, where R and R² log R count
  const auto plate = test::lattice_mesh(20, 6, 3.0, 2.0, [](int, int) { return true; });
  expect_agreement("shallow", plate, 0.1, {1e-3});
  const auto coarse = test::lattice_mesh(12, 5, 20.0, 20.0, [](int, int) { return true; });
  expect_agreement("coarse", coarse, kInfinity, {1e-3, 1e-5});
}

TEST(twin_FastPressureOperatorLong, EqualsTheLatticeOperatorOn287ThousandNodes) {
  // Too many for a dense matrix; the lattice operator is exact there, and equals it where there is
  const auto plate = mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = 690, .ny = 138});
  const green::GreenFunction exact(kNu, 58.5);
  const green::GreenTable green(exact, 4.0 * (plate.upper() - plate.lower()).norm());
  const MatXcd x = test_columns(plate, exact.wavenumber());
  MatXcd expected(x.rows(), 2), actual(x.rows(), 2);
  const auto lattice =
      std::make_shared<const LatticePlan>(plate, IntegralOptions{.tolerance = 1e-10});
  LatticePressureOperator(lattice, green).apply(x, expected);
  for (const double tolerance : kTolerances)
    for (const SumEngine engine : {SumEngine::kPfft, SumEngine::kMultipole}) {
      const auto plan = std::make_shared<const FastPressurePlan>(
          plate,
          FastOptions{
              .engine = engine, .tolerance = tolerance, .max_wavenumber = exact.wavenumber()});
      FastPressureOperator(plan, green).apply(x, actual);
      for (Index column = 0; column < 2; ++column) {
        const double error = (actual.col(column) - expected.col(column)).norm() /
                             (expected.col(column) - x.col(column)).norm();
        EXPECT_LE(error, 10.0 * tolerance) << name_of(engine) << ", column " << column;
      }
    }
}

TEST(FastPressureOperator, HasTheSameBitsForAnyNumberOfThreadsAndInBlocks) {
  const mesh::Q8Mesh mesh = read("ring.msh");
  const green::GreenFunction exact(kNu, 20.0);
  const green::GreenTable green(exact, 4.0 * (mesh.upper() - mesh.lower()).norm());
  const MatXcd x = MatXcd::Random(mesh.node_count(), 9);
  const int before = omp_get_max_threads();
  for (const SumEngine engine : {SumEngine::kPfft, SumEngine::kMultipole}) {
    MatXcd first;
    for (const int threads : {1, 2, 3, 7}) {
      omp_set_num_threads(threads);
      const auto plan = std::make_shared<const FastPressurePlan>(
          mesh, FastOptions{.engine = engine, .max_wavenumber = exact.wavenumber()});
      const FastPressureOperator fast(plan, green);
      MatXcd y(x.rows(), 9), alone(x.rows(), 1);
      fast.apply(x, y);
      fast.apply(x.col(1), alone);
      if (threads == 1) first = y;
      EXPECT_EQ(first, y) << name_of(engine) << ", " << threads << " threads";
      EXPECT_EQ(y.col(1), alone.col(0)) << name_of(engine) << ", " << threads << " threads";
    }
  }
  omp_set_num_threads(before);
}

TEST(FastPressureOperator, RefusesWhatItCannotDo) {
  const mesh::Q8Mesh mesh = read("ring.msh");
  const auto plan_with = [&](double tolerance, double wavenumber) {
    return std::make_shared<const FastPressurePlan>(
        mesh,
        FastOptions{
            .engine = SumEngine::kPfft, .tolerance = tolerance, .max_wavenumber = wavenumber});
  };
  try {
    plan_with(1e-8, 0.1);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "invalid operator tolerance = 1e-08 (must be 1e-07 to 1e-2)");
  }
  EXPECT_THROW(plan_with(1e-4, 50.0), InputError);
  const green::GreenTable green(green::GreenFunction(kNu, 20.0), 500.0);
  EXPECT_THROW(FastPressureOperator(plan_with(1e-4, 0.05), green), InputError);
}

}  // namespace
}  // namespace floe::bem
