#include "fabricated_results.hpp"

#include <floe/estimate.hpp>
#include <floe/numeric/error.hpp>
#include <floe/preflight.hpp>
#include <floe/wave/dispersion.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace floe {
namespace {

using test::small_case;
using testing::HasSubstr;
using testing::IsEmpty;

// A deep-water frequency whose wave is this long [m]
double omega_of(double wavelength) {
  return wave::angular_frequency(2.0 * std::numbers::pi / wavelength, small_case().water);
}

mesh::Q8Mesh rectangle(double length, double width, int nx, int ny, double grading = 1.0) {
  return mesh::make_rectangle(
      {.length = length, .width = width, .nx = nx, .ny = ny, .grading = grading});
}

TEST(Preflight, CountsNodesHalfAnEdgeApart) {
  Case data = small_case();
  data.omega = {omega_of(25.0)};
  const Preflight found = preflight(data, rectangle(40.0, 20.0, 4, 2));
  // 10 m elements, nodes 5 m apart, waves of 25 m
  EXPECT_NEAR(found.resolution.at(0).nodes_per_wavelength, 5.0, 1e-9);
  EXPECT_GT(found.resolution.at(0).flexural_wavelength, 25.0) << "a stiff plate lengthens waves";
  EXPECT_THAT(found.warnings, IsEmpty());
}

TEST(Preflight, CountsTheShorterOfBothWaves) {
  Case data = small_case();
  data.plate.youngs_modulus = 1e3;
  data.plate.density = 1000.0;  // limp and heavy: the wave under the plate is the shorter one
  data.omega = {1.4};
  const Resolution r = preflight(data, rectangle(40.0, 20.0, 4, 2)).resolution.at(0);
  EXPECT_LT(r.flexural_wavelength, r.wavelength);
  EXPECT_EQ(r.least_nodes(), r.nodes_per_flexural_wavelength);
}

TEST(Preflight, WarnsBelowFourNodesAndRefusesBelowTwo) {
  Case data = small_case();
  data.omega = {0.4, omega_of(15.0)};  // 3 nodes
  const Preflight warned = preflight(data, rectangle(40.0, 20.0, 4, 2));
  ASSERT_EQ(warned.warnings.size(), 1u);
  EXPECT_THAT(warned.warnings[0], HasSubstr("coarse mesh: 3 nodes per wavelength"));
  EXPECT_THAT(warned.warnings[0], HasSubstr("1 of 2 frequencies"));
  EXPECT_NO_THROW(require_resolution(data, warned));

  data.omega.push_back(omega_of(5.0));  // 1 node
  const Preflight refused = preflight(data, rectangle(40.0, 20.0, 4, 2));
  EXPECT_THROW(require_resolution(data, refused), InputError);
  data.allow_coarse = true;
  EXPECT_NO_THROW(require_resolution(data, refused));
}

TEST(Preflight, LooksAtThePlatesOwnMesh) {
  const Case data = small_case();
  const mesh::Q8Mesh fluid = rectangle(40.0, 20.0, 8, 4), plate = rectangle(40.0, 20.0, 2, 1);
  const Resolution r = preflight(data, fluid, &plate).resolution.at(0);
  EXPECT_NEAR(r.nodes_per_wavelength / r.wavelength, 1.0 / 2.5, 1e-12);
  EXPECT_NEAR(r.nodes_per_flexural_wavelength / r.flexural_wavelength, 1.0 / 10.0, 1e-12);
}

// The limp half has the shorter wave; where its elements are much shorter, the stiff half's
// counts again
TEST(Preflight, LooksAtEachRegionOfThePlate) {
  Case data = small_case();
  data.omega = {1.4};
  plate::PlateProperties limp = data.plate;
  limp.youngs_modulus = 1e3;
  limp.density = 1000.0;
  const mesh::Q8Mesh mesh = rectangle(40.0, 20.0, 4, 2);
  const plate::PlateRegions halves({data.plate, limp}, {0, 0, 1, 1, 0, 0, 1, 1});
  const double stiff_wave = preflight(data, mesh).resolution.at(0).flexural_wavelength;
  const plate::PlateRegions all_limp(limp);
  const double limp_wave =
      preflight(data, mesh, nullptr, &all_limp).resolution.at(0).flexural_wavelength;
  ASSERT_LT(limp_wave, stiff_wave);
  const Resolution r = preflight(data, mesh, nullptr, &halves).resolution.at(0);
  EXPECT_EQ(r.flexural_wavelength, limp_wave);
  EXPECT_NEAR(r.nodes_per_flexural_wavelength, limp_wave / 5.0, 1e-12);

  // Limp is the first element alone, a fortieth as long as the longest
  const mesh::Q8Mesh graded = rectangle(400.0, 1.0, 41, 1, 100.0);
  std::vector<int> ends(41, 0);
  ends.front() = 1;
  const plate::PlateRegions end({data.plate, limp}, ends);
  EXPECT_EQ(preflight(data, graded, nullptr, &end).resolution.at(0).flexural_wavelength,
            stiff_wave);
}

TEST(Preflight, WarnsOfBadShapesAndUnits) {
  const Case data = small_case();
  const auto warnings = [&](const mesh::Q8Mesh& mesh) {
    std::string all;
    for (const std::string& warning : preflight(data, mesh).warnings) all += warning + "\n";
    return all;
  };
  EXPECT_THAT(warnings(rectangle(40.0, 20.0, 1, 20)),
              HasSubstr("slender elements: aspect ratio = 40"));
  EXPECT_THAT(warnings(rectangle(40.0, 20.0, 3, 3, 50.0)), HasSubstr("uneven mesh"));
  EXPECT_THAT(warnings(rectangle(4e7, 2e7, 4, 2)), HasSubstr("is the mesh in metres?"));
}

TEST(Estimate, ChargesTheDenseMatrixAndItsFactors) {
  Case data = small_case();
  data.method = SolverMethod::kDense;
  const mesh::Q8Mesh mesh = rectangle(300.0, 60.0, 50, 10);
  const double matrices = 32.0 * 1621.0 * 1621.0;  // the matrix and its factors
  const Estimate needed = estimate(data, mesh, nullptr, 1);
  EXPECT_EQ(needed.nodes, 1621);
  EXPECT_EQ(needed.method, "dense");
  EXPECT_GE(needed.memory, matrices);
  EXPECT_LE(needed.memory, 2.0 * matrices);
  EXPECT_LT(estimate(data, mesh, nullptr, 2).seconds, needed.seconds);
}

TEST(Estimate, ChoosesTheMethodByTheMesh) {
  Case data = small_case();
  const auto chosen = [&](const mesh::Q8Mesh& mesh) { return resolve_method(data, mesh); };
  EXPECT_EQ(chosen(rectangle(300.0, 60.0, 10, 2)), SolverMethod::kDense);
  EXPECT_EQ(chosen(rectangle(300.0, 60.0, 50, 10)), SolverMethod::kLattice);
  EXPECT_EQ(chosen(rectangle(300.0, 60.0, 50, 10, 3.0)), SolverMethod::kPfft);
  data.method = SolverMethod::kFmm;
  EXPECT_EQ(chosen(rectangle(300.0, 60.0, 10, 2)), SolverMethod::kFmm);
}

// What is free at the moment has no say
TEST(Estimate, PlansForWhatIsAskedForAndNotForWhatIsFree) {
  Case data;
  EXPECT_EQ(plan_budget(data), kPlannedMemory);
  data.memory_limit = 5e9;
  EXPECT_EQ(plan_budget(data), 5e9);
  data.plan_memory = 7e9;  // of an earlier run
  EXPECT_EQ(plan_budget(data), 7e9);
}

TEST(Estimate, RefusesBeyondTheBudgetNamingWhatHelps) {
  Estimate needed;
  needed.method = "dense";
  needed.nodes = 10;
  needed.memory = 2e9;
  needed.knobs = "fewer modes";
  EXPECT_NO_THROW(require_budget(needed, 2e9));
  try {
    require_budget(needed, 1e9);
    FAIL() << "accepted";
  } catch (const BudgetError& error) {
    EXPECT_STREQ(error.what(),
                 "invalid memory need = 2.00 GB by method dense at 10 nodes (must be at most 1.00 "
                 "GB; what lowers or allows it: fewer modes)");
  }
}

TEST(Estimate, ShowsBytesWithThreeDigits) {
  EXPECT_EQ(format_bytes(17.0), "17 B");
  EXPECT_EQ(format_bytes(999.6), "1.00 kB");
  EXPECT_EQ(format_bytes(45.44e6), "45.4 MB");
  EXPECT_EQ(format_bytes(210e6), "210 MB");
}

}  // namespace
}  // namespace floe
