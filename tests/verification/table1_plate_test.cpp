#include <floe/analysis.hpp>

#include <csv.hpp>
#include <expect.hpp>
#include <gtest/gtest.h>
#include <recorded_run.hpp>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

// The paper's plate of Table 1 in waves, against an independent spectral solution with the same 30
// dry modes, and against that solution's section forces with all modes.
namespace floe {
namespace {

const std::vector<double> kFrequencies{0.42, 0.72, 1.01};
const std::vector<double> kHeadings{0.0, 60.0};

Case table1_case(int nx, int ny, int modes = 30, double grading = 1.0) {
  Case data = test::table1_case(nx, ny);
  data.mesh = mesh::RectangleOptions{
      .length = 300.0, .width = 60.0, .nx = nx, .ny = ny, .grading = grading};
  data.mode_count = modes;
  data.omega = kFrequencies;
  data.heading_deg = kHeadings;
  return data;
}

// Largest |w - reference| over P1 … P5, all frequencies and headings
double worst_rao_error(const test::RecordedRun& run) {
  const auto table =
      test::read_reference("table1_rao_points.csv").where("theory", "mindlin_30modes");
  double worst = 0.0;
  int compared = 0;
  for (const FrequencyResult& result : run.frequencies)
    for (std::size_t b = 0; b < kHeadings.size(); ++b)
      for (std::size_t i = 0; i < run.data.points.size(); ++i) {
        const auto row = table.where("omega", result.omega)
                             .where("heading_deg", kHeadings[b])
                             .where("point", run.data.points[i].name);
        const Complex expected(row.numbers("re_w").at(0), row.numbers("im_w").at(0));
        const Complex actual =
            result.point_deflection(static_cast<Index>(i), static_cast<Index>(b));
        worst = std::max(worst, std::abs(actual - expected));
        ++compared;
      }
  EXPECT_EQ(compared, 30);
  return worst;
}

TEST(verification_Table1Plate, MovesAsTheReferenceSaysAt6MetreElements) {
  EXPECT_LE(worst_rao_error(test::run(table1_case(50, 10))), 0.005);
}

TEST(verification_Table1Plate, MovesAsTheReferenceSaysAt3MetreElements) {
  EXPECT_LE(worst_rao_error(test::run(table1_case(100, 20))), 0.0015);
}

TEST(order_Table1PlateLong, MotionsConvergeWithOrder1Point8OrMore) {
  const std::vector<double> edge{6.0, 4.0, 3.0, 2.5};
  std::vector<double> error;
  for (const auto& [nx, ny] : {std::pair{50, 10}, {75, 15}, {100, 20}, {120, 24}})
    error.push_back(worst_rao_error(test::run(table1_case(nx, ny))));
  for (std::size_t i = 0; i < edge.size(); ++i)
    std::printf("element %.3g m: worst |w| error %.2e\n", edge[i], error[i]);
  EXPECT_GE(test::observed_order(edge, error), 1.8);
}

TEST(order_Table1Plate, MotionsConvergeOnCoarserMeshesToo) {
  const std::vector<double> edge{10.0, 7.5, 6.0};
  std::vector<double> error;
  for (const auto& [nx, ny] : {std::pair{30, 6}, {40, 8}, {50, 10}})
    error.push_back(worst_rao_error(test::run(table1_case(nx, ny))));
  EXPECT_GE(test::observed_order(edge, error), 1.8);
}

TEST(verification_Table1PlateLong, AMeshGradedToTheEdgesGains) {
  const double equal = worst_rao_error(test::run(table1_case(50, 10)));
  const double graded = worst_rao_error(test::run(table1_case(50, 10, 30, 2.0)));
  std::printf("6 m elements: %.2e, graded 2 : 1: %.2e\n", equal, graded);
  EXPECT_LT(graded, equal);
}

// Largest errors of bending moment and shear force on the centreline at ω = 1.01, heading 0,
// relative to their largest values, farther than 15 m from the ends
std::array<double, 2> section_force_errors(int nx, int ny, int modes) {
  Case data = table1_case(nx, ny, modes);
  data.omega = {1.01};
  data.heading_deg = {0.0};
  data.quantities = {response::Quantity::kBendingMomentX, response::Quantity::kShearForceX};
  const auto table = test::read_reference("table1_moments_centreline.csv");
  const auto x = table.numbers("x");
  data.points.clear();
  for (const double at : x) data.points.push_back({"x" + std::to_string(at), {at, 0.0}});
  const test::RecordedRun run = test::run(data);

  std::array<double, 2> errors{};
  for (const auto& [q, re, im] : {std::tuple{0, "re_Mx", "im_Mx"}, {1, "re_Qx", "im_Qx"}}) {
    const auto real = table.numbers(re), imaginary = table.numbers(im);
    double largest = 0.0, worst = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Complex expected(real[i], imaginary[i]);
      const Complex actual = run.frequencies[0].point_quantities[q](static_cast<Index>(i), 0);
      largest = std::max(largest, std::abs(expected));
      if (std::abs(x[i]) < 135.5) worst = std::max(worst, std::abs(actual - expected));
    }
    errors[q] = worst / largest;
  }
  return errors;
}

TEST(verification_Table1Plate, BendingMomentsOnTheCentrelineAgreeTo2Percent) {
  // With 30 modes: the static correction stands for all others
  const auto [moment, shear] = section_force_errors(50, 10, 30);
  EXPECT_LE(moment, 0.02);
  EXPECT_LE(shear, 0.03);
}

TEST(order_Table1PlateLong, BendingMomentsConvergeInModesAndElements) {
  std::map<std::pair<int, int>, double> error;
  for (const int nx : {50, 100})
    for (const int modes : {30, 60, 120}) {
      const auto [moment, shear] = section_force_errors(nx, nx / 5, modes);
      std::printf("%g m elements, %d modes: Mx %.2e, Qx %.2e of the maximum\n", 300.0 / nx, modes,
                  moment, shear);
      error[{nx, modes}] = moment;
    }
  for (const int modes : {30, 60, 120})
    EXPECT_LT((error[{100, modes}]), (error[{50, modes}]) / 2.0);
}

}  // namespace
}  // namespace floe
