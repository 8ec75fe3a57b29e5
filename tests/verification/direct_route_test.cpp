// The direct route, one coupled equation a frequency without modes, against the modal route and
// the reference.

#include <floe/numeric/error.hpp>
#include <floe/response/modal_basis.hpp>

#include <csv.hpp>
#include <gtest/gtest.h>
#include <recorded_run.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace floe {
namespace {

using response::Quantity;

// A small plate with waves of its own length and shorter
Case small_case() {
  Case data = test::table1_case(20, 4);
  data.omega = {0.5, 0.8};
  data.heading_deg = {0.0, 40.0};
  data.tolerance = 1e-8;
  data.method = SolverMethod::kLattice;
  return data;
}

test::RecordedRun run_by(Case data, SolverRoute route) {
  data.route = route;
  return test::run(data);
}

// Largest difference of a result over frequencies, relative to its largest value
template <typename Value>
double difference(const test::RecordedRun& a, const test::RecordedRun& b, const Value& value) {
  double worst = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < a.frequencies.size(); ++i) {
    const MatXcd x = value(a.frequencies[i]), y = value(b.frequencies[i]);
    worst = std::max(worst, (x - y).cwiseAbs().maxCoeff());
    largest = std::max(largest, x.cwiseAbs().maxCoeff());
  }
  return worst / largest;
}

const auto deflection = [](const FrequencyResult& r) { return r.point_deflection; };

// The modal route misses what the modes left out carry, and takes its exciting forces by
// reciprocity, which holds as well as the mesh: the first error falls with modes, the second with
// elements
TEST(limit_DirectRoute, IsTheModalRouteWithAllModes) {
  Case data = small_case();
  data.mode_count = 12;
  const double few =
      difference(run_by(data, SolverRoute::kDirect), run_by(data, SolverRoute::kModal), deflection);
  data.mode_count = 75;
  const double many =
      difference(run_by(data, SolverRoute::kDirect), run_by(data, SolverRoute::kModal), deflection);
  data.mesh = mesh::RectangleOptions{.length = 300.0, .width = 60.0, .nx = 40, .ny = 8};
  const double fine =
      difference(run_by(data, SolverRoute::kDirect), run_by(data, SolverRoute::kModal), deflection);
  EXPECT_LT(many, 0.25 * few);
  EXPECT_LT(fine, 0.35 * many);  // order above 1.5
}

TEST(limit_DirectRoute, TellsSlopesForcesAndPressuresOfTheModalRoute) {
  Case data = small_case();
  data.mesh = mesh::RectangleOptions{.length = 300.0, .width = 60.0, .nx = 40, .ny = 8};
  data.quantities = {Quantity::kSlopeX, Quantity::kAcceleration, Quantity::kBendingMomentY,
                     Quantity::kPressure, Quantity::kRelativeElevation};
  data.wave_points = {{"lee", {200.0, 10.0}}};
  data.plate.loss_factor = 0.05;
  data.mode_count = 180;
  const test::RecordedRun direct = run_by(data, SolverRoute::kDirect);
  const test::RecordedRun modal = run_by(data, SolverRoute::kModal);
  for (std::size_t q = 0; q < data.quantities.size(); ++q)
    EXPECT_LT(
        difference(direct, modal, [&](const FrequencyResult& r) { return r.point_quantities[q]; }),
        2e-3)
        << response::name(data.quantities[q]);
  EXPECT_LT(difference(direct, modal, [](const FrequencyResult& r) { return r.wave_elevation; }),
            2e-3);
  EXPECT_LT(difference(direct, modal,
                       [](const FrequencyResult& r) { return MatXcd(r.fields.at(0).pressure); }),
            2e-2);  // its largest values stand at the edges, where modes converge slowest
}

TEST(twin_DirectRoute, IsTheSameByEveryMethodAndByAPlateMeshOfItsOwn) {
  Case data = small_case();
  const test::RecordedRun lattice = run_by(data, SolverRoute::kDirect);
  data.method = SolverMethod::kDense;
  EXPECT_LT(difference(lattice, run_by(data, SolverRoute::kDirect), deflection), 1e-6);
  data.method = SolverMethod::kPfft;
  EXPECT_LT(difference(lattice, run_by(data, SolverRoute::kDirect), deflection), 1e-5);
  data.method = SolverMethod::kLattice;
  data.plate_mesh = {mesh::RectangleOptions{.length = 300.0, .width = 60.0, .nx = 10, .ny = 2}};
  EXPECT_LT(difference(lattice, run_by(data, SolverRoute::kDirect), deflection), 5e-3);
}

TEST(identity_DirectRoute, KeepsEnergyAndReciprocity) {
  for (const double loss : {0.0, 0.1}) {
    Case data = small_case();
    data.plate.loss_factor = loss;
    for (const FrequencyResult& r : run_by(data, SolverRoute::kDirect).frequencies) {
      EXPECT_LE(r.report.true_residual, 1e-8);
      EXPECT_LT(r.report.energy_error, 2e-3) << loss;  // of the mesh, 15 m elements
      EXPECT_LT(r.report.reciprocity_error, 2e-3) << loss;
    }
  }
}

// The rows of all modes, which a sum of 30 misses by 7e-4
TEST(verification_DirectRoute, GivesTheReferenceOfAllModes) {
  Case data = test::table1_case(50, 10);
  data.omega = {0.72, 1.01};
  data.heading_deg = {0.0, 60.0};
  const test::RecordedRun direct = run_by(data, SolverRoute::kDirect);
  const auto table = test::read_reference("table1_rao_points.csv").where("theory", "mindlin");
  for (const FrequencyResult& r : direct.frequencies)
    for (std::size_t b = 0; b < data.heading_deg.size(); ++b)
      for (std::size_t i = 0; i < data.points.size(); ++i) {
        const auto row = table.where("omega", r.omega)
                             .where("heading_deg", data.heading_deg[b])
                             .where("point", data.points[i].name);
        const Complex expected(row.numbers("re_w").at(0), row.numbers("im_w").at(0));
        const Complex actual = r.point_deflection(static_cast<Index>(i), static_cast<Index>(b));
        EXPECT_LT(std::abs(actual - expected), 0.005);  // 6 m elements
      }
}

TEST(DirectRoute, RefusesAPlateWhoseInertiaOutweighsTheWater) {
  Case data = small_case();
  data.omega = {4.5};
  data.allow_coarse = true;
  EXPECT_THROW(run_by(data, SolverRoute::kDirect), InputError);
}

}  // namespace
}  // namespace floe
