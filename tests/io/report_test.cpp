#include "fabricated_results.hpp"
#include "io/packed_array.hpp"
#include "io/report_motions.hpp"
#include "recorded_run.hpp"
#include "test_paths.hpp"

#include <floe/io/report.hpp>
#include <floe/numeric/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>

namespace floe::io {
namespace {

using testing::HasSubstr;
using testing::Not;

// The JSON between the page's data tags
nlohmann::json data_of(const std::string& page) {
  const std::string tag = "<script id=\"floe-data\" type=\"application/json\">";
  const std::size_t first = page.find(tag) + tag.size();
  return nlohmann::json::parse(page.substr(first, page.find("</script>", first) - first));
}

class Report : public testing::Test {
 protected:
  Report() {
    modes_.shape = MatXd::Constant(3 * mesh_.node_count(), 4, 0.5);
    results_ = {test::small_result(0.4), test::small_result(0.5)};
  }
  std::string page() const {
    return report_page({.data = data_,
                        .mesh = mesh_,
                        .fluid_nodes = mesh_.node_count(),
                        .fluid_elements = mesh_.element_count(),
                        .modes = modes_,
                        .results = results_,
                        .status = "complete",
                        .warnings = warnings_,
                        .stages = {},
                        .case_text = "[water]",
                        .seas = {}});
  }
  Case data_ = test::small_case();
  mesh::Q8Mesh mesh_ = test::small_mesh();
  plate::DryModes modes_ = test::small_modes();
  std::vector<FrequencyResult> results_;
  std::vector<std::string> warnings_;
};

TEST(Base64, EncodesTheExamplesOfRfc4648) {
  const auto encoded = [](const std::string& text) {
    return base64(std::as_bytes(std::span<const char>(text)));
  };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

TEST_F(Report, HasThePointsWavesAndChecksOfTheRun) {
  const nlohmann::json data = data_of(page());
  EXPECT_EQ(data["waves"]["omega"], (std::vector<double>{0.4, 0.5}));
  EXPECT_EQ(data["points"][1]["name"], "P2");
  EXPECT_EQ(data["quantities"][1]["unit"], "Pa");
  EXPECT_EQ(data["checks"][0]["name"], "residual");
  EXPECT_EQ(data["checks"][0]["status"], "good");
}

TEST_F(Report, LoadsNothingFromOutside) {
  EXPECT_THAT(page(), Not(HasSubstr("src=\"")));
  EXPECT_THAT(page(), Not(HasSubstr("<link")));
  EXPECT_THAT(page(), HasSubstr("default-src 'none'"));
}

TEST_F(Report, LetsNoTextOfTheUserOutOfItsData) {
  data_.title = "</script><script>alert(1)</script>";
  warnings_ = {"<!-- <b>"};
  EXPECT_THAT(page(), Not(HasSubstr("<script>alert")));
  EXPECT_EQ(data_of(page())["title"], data_.title);
  EXPECT_EQ(data_of(page())["warnings"][0], "<!-- <b>");
}

TEST_F(Report, TellsAResidualAboveTheTolerance) {
  results_[1].report.true_residual = 3e-6;
  EXPECT_EQ(data_of(page())["checks"][0]["status"], "attention");
  results_[1].report.true_residual = std::nan("");
  EXPECT_EQ(data_of(page())["checks"][0]["status"], "bad");
}

TEST_F(Report, StaysBelowFiveMegabytesForManyWaves) {
  results_.clear();
  for (int i = 0; i < 4000; ++i) results_.push_back(test::small_result(0.3 + 1e-3 * i));
  data_.lines[0].count = 5;
  EXPECT_LT(page().size(), 5'000'000u);
}

TEST_F(Report, NeedsAFinishedFrequency) {
  results_.clear();
  EXPECT_THROW(page(), InputError);
}

TEST_F(Report, HasTheMomentsOfEveryMode) {
  const nlohmann::json data = data_of(page());
  EXPECT_EQ(data["moments"]["x"].size(), 4u);
  EXPECT_EQ(data["moments"]["y"].size(), 4u);
}

// A sea whose numbers are only there to be shown
ReportSea shown_sea(const Case& data, Index nodes) {
  ReportSea sea{.name = "design",
                .text = "bretschneider (significant_height = 2 m), spreading cos2",
                .mean_heading_deg = {0.0, 90.0},
                .std = {},
                .zero_crossing_period = {},
                .significant = {},
                .most_probable_maximum = {},
                .spectrum_omega = {0.4, 0.6, 0.8},
                .spectra = {},
                .deflection_std = MatXd::Constant(nodes, 2, 0.2)};
  const std::size_t count = 2 * data.quantities.size() * data.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    sea.std.push_back(0.1 + 0.01 * static_cast<double>(i));
    sea.zero_crossing_period.push_back(6.5);
    sea.significant.push_back(2.0 * sea.std.back());
    sea.most_probable_maximum.push_back(3.9 * sea.std.back());
    sea.spectra.insert(sea.spectra.end(), {0.01, 0.1, 0.02});
  }
  return sea;
}

void write_page(const std::string& name, const std::string& page) {
  std::ofstream file(name, std::ios::binary);
  file << page;
  EXPECT_TRUE(file.good()) << name;
}

// The pages that the browser's test opens (report/tests): a whole run, coarse; and the same with
// text of a hostile user
TEST(ReportPage, OfAWholeRunIsWrittenForTheBrowser) {
  Case data = test::table1_case(20, 4);
  data.title = "Plate of Table 1, coarse";
  data.omega = {0.42, 0.48, 0.58, 0.72};
  data.heading_deg = {0.0, 30.0, 90.0};
  data.mode_count = 16;
  data.lines = {{"centreline", {-150.0, 0.0}, {150.0, 0.0}, 31}};
  data.quantities = {response::Quantity::kDeflection, response::Quantity::kBendingMomentX};
  const test::RecordedRun run = test::run(data);
  const mesh::Q8Mesh mesh = mesh::make_rectangle(std::get<mesh::RectangleOptions>(data.mesh));
  ReportContent content{.data = data,
                        .mesh = mesh,
                        .fluid_nodes = mesh.node_count(),
                        .fluid_elements = mesh.element_count(),
                        .modes = run.modes,
                        .results = run.frequencies,
                        .status = "complete",
                        .warnings = run.warnings,
                        .stages = {{"dry modes", 0.1, 1e8}},
                        .case_text = "title = \"Plate of Table 1, coarse\"",
                        .seas = {shown_sea(data, mesh.node_count())}};
  const std::string page = report_page(content);
  write_page(FLOE_REPORT_PAGE, page);
  EXPECT_GT(data_of(page)["triangles"].size() + data_of(page)["surface"].size(), 3u);

  const std::string attack =
      "</script><script>window.owned = 1</script><img src=x onerror=owned=1>";
  data.title = attack;
  data.points.front().name = "<b>P1</b>";
  content.warnings = {attack, "second"};
  content.case_text = attack;
  content.seas.front().name = attack;
  content.seas.front().text = attack;
  write_page(std::string(FLOE_REPORT_PAGE) + ".hostile.html", report_page(content));
}

// Motions of the waves whose fields are stored stand for the modes
TEST(ReportPage, OfTheDirectRouteShowsTheStoredFields) {
  Case data = test::table1_case(10, 2);
  data.title = "Direct route";
  data.route = SolverRoute::kDirect;
  data.omega = {0.48, 0.6, 0.72};
  data.heading_deg = {0.0, 45.0, 90.0};
  for (const double omega : {0.48, 0.72})
    for (const double heading : {0.0, 90.0}) data.fields.push_back({omega, heading});
  data.points = {{"P1", {-150.0, -30.0}}, {"P5", {0.0, 0.0}}};
  data.quantities = {response::Quantity::kDeflection, response::Quantity::kBendingMomentX};
  const test::RecordedRun run = test::run(data);
  const ReportMotions motions = stored_motions(data, run.frequencies);
  EXPECT_EQ(motions.frequencies, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(motions.headings, (std::vector<std::size_t>{0, 2}));

  // The last wave, ω = 0.72 from 90°, at the node of P1: the same sum over the same unknowns
  const mesh::Q8Mesh& mesh = *run.fluid_mesh;
  Index node = 0;
  (mesh.nodes().colwise() - data.points[0].position).colwise().norm().minCoeff(&node);
  const Complex shown(motions.parts(3 * node, 6), motions.parts(3 * node, 7));
  EXPECT_LT(std::abs(shown - run.frequencies[2].point_deflection(0, 2)), 1e-12);

  const plate::DryModes none;
  const std::string page = report_page({.data = data,
                                        .mesh = mesh,
                                        .fluid_nodes = mesh.node_count(),
                                        .fluid_elements = mesh.element_count(),
                                        .modes = none,
                                        .results = run.frequencies,
                                        .status = "complete",
                                        .warnings = run.warnings,
                                        .stages = {{"radiation", 0.1, 1e8}},
                                        .case_text = "solver.route = \"direct\"",
                                        .seas = {},
                                        .motions = motions});
  write_page(std::string(FLOE_REPORT_PAGE) + ".direct.html", page);
  const nlohmann::json shown_data = data_of(page);
  EXPECT_EQ(shown_data["modes"]["count"], 8);
  EXPECT_EQ(shown_data["moments"]["y"].size(), 8u);
  EXPECT_EQ(shown_data["waves"]["heading_deg"], (std::vector<double>{0.0, 90.0}));
  EXPECT_EQ(shown_data["waves"]["computed"], 9);
  EXPECT_EQ(shown_data["convergence"].size(), 3u);
  EXPECT_TRUE(shown_data["hydrodynamics"].is_null());
}

TEST(ReportPage, OfTheDirectRouteNeedsAField) {
  EXPECT_THROW(stored_motions(test::small_case(), {FrequencyResult{}}), StoreError);
}

}  // namespace
}  // namespace floe::io
