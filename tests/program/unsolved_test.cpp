#include "csv.hpp"
#include "floe_program.hpp"
#include "io/netcdf_file.hpp"
#include "stored_products.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

// Frequencies at which the iteration does not converge.
namespace floe {
namespace {

using test::expect_same_products;
using test::ProgramResult;
using test::run_floe;
using test::TestFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string case_of(const std::string& mesh, const std::string& omega, const std::string& solver) {
  return R"([water]
depth = 58.5
[plate]
thickness = 2.0
youngs_modulus = 1.19e10
poisson_ratio = 0.13
density = 256.25
[mesh]
rectangle = )" +
         mesh + "\n[waves]\nomega = " + omega +
         "\nheading_deg = [0]\n[output]\npoints = { P = [0, 0] }\n[solver]\n" + solver + "\n";
}

// Values of a column, by its name
std::vector<std::string> column(const TestFolder& folder, const std::string& file,
                                const std::string& name) {
  return test::read_csv(folder.path() / file).strings(name);
}

TEST(Unsolved, IsTriedOnceMoreByADenseFactorisation) {
  const TestFolder folder;
  const std::string mesh = "{ length = 60.0, width = 12.0, nx = 20, ny = 4 }";
  const std::string modes = "[modes]\ncount = 4\n";
  folder.write("case.toml", case_of(mesh, "[0.4, 4.0]", "method = \"lattice\"") + modes);
  folder.write("dense.toml", case_of(mesh, "[0.4, 4.0]", "method = \"dense\"") + modes);
  const ProgramResult result = run_floe(folder, "run case.toml");
  ASSERT_EQ(result.code, 0) << result.error;
  EXPECT_THAT(result.output, AllOf(HasSubstr("note       omega = 4 rad/s: true residual of column"),
                                   HasSubstr("tried once more by a dense factorisation")));
  const auto run = nlohmann::json::parse(folder.read("case.out/run.json"));
  EXPECT_EQ(run.at("status"), "complete");
  EXPECT_EQ(run.at("frequencies").at(0).at("method"), "lattice");
  EXPECT_EQ(run.at("frequencies").at(1).at("method"), "dense");
  EXPECT_LT(run.at("frequencies").at(1).at("true_residual").get<double>(), 1e-10);

  ASSERT_EQ(run_floe(folder, "run dense.toml").code, 0);
  EXPECT_EQ(column(folder, "case.out/rao_points.csv", "re_w").at(1),
            column(folder, "dense.out/rao_points.csv", "re_w").at(1));
}

TEST(Unsolved, IsFlaggedAndTheOthersAreKept) {
  const TestFolder folder;
  folder.write("case.toml", case_of("{ length = 180.0, width = 30.0, nx = 44, ny = 8 }",
                                    "[4.3, 0.4]", "method = \"lattice\"\nroute = \"direct\""));
  const ProgramResult result = run_floe(folder, "run case.toml --allow-coarse");
  EXPECT_EQ(result.code, 8);
  EXPECT_THAT(result.error,
              AllOf(HasSubstr("floe: error: 1 of 2 frequencies has no result: omega = 4.3 rad/s: "
                              "true residual of column 1 = "),
                    HasSubstr("nodes per wavelength (refine it, 6 are enough)")));
  EXPECT_THAT(result.output, AllOf(HasSubstr("tried once more with more steps"),
                                   HasSubstr("kept       1 of 2 frequencies in case.out/")));

  // What is on the disk
  const auto run = nlohmann::json::parse(folder.read("case.out/run.json"));
  EXPECT_EQ(run.at("status"), "failed");
  EXPECT_EQ(run.at("frequencies").at(0).at("status"), "solved");
  const auto& failed = run.at("frequencies").at(1);
  EXPECT_EQ(failed.at("status"), "failed");
  EXPECT_EQ(failed.at("omega"), 4.3);
  EXPECT_THAT(failed.at("failure").get<std::string>(), HasSubstr("true residual of column 1"));
  EXPECT_FALSE(failed.contains("true_residual"));
  EXPECT_THAT(run.at("warnings").back().get<std::string>(), HasSubstr("no result: omega = 4.3"));
  const auto values = column(folder, "case.out/rao_points.csv", "abs_w");
  EXPECT_TRUE(std::isfinite(std::stod(values.at(0))));
  EXPECT_EQ(values.at(1), "nan");
  for (const char* column_name : {"re_w", "im_w"})
    EXPECT_EQ(column(folder, "case.out/rao_points.csv", column_name).at(1), "nan");

  // What other commands tell and make of it
  EXPECT_THAT(run_floe(folder, "status case.out").output,
              AllOf(HasSubstr("state      failed"), HasSubstr("failed  omega = 4.3 rad/s: true"),
                    HasSubstr("done       1 of 2 frequencies")));
  std::filesystem::copy(folder.path() / "case.out", folder.path() / "again",
                        std::filesystem::copy_options::recursive);
  const ProgramResult exported = run_floe(folder, "export again");
  EXPECT_EQ(exported.code, 0) << exported.error;
  EXPECT_THAT(exported.output, HasSubstr("1 of 2 frequencies has no result: omega = 4.3 rad/s"));
  expect_same_products(folder, "case.out", "again");
  EXPECT_EQ(run_floe(folder, "merge case.out -o merged").code, 8);
  expect_same_products(folder, "case.out", "merged");
  EXPECT_EQ(run_floe(folder, "report case.out").code, 0);
}

TEST(Unsolved, OfTheDirectRouteIsAPlateTooHeavyForTheFrequency) {
  const TestFolder folder;
  folder.write("case.toml", case_of("{ length = 60.0, width = 12.0, nx = 20, ny = 4 }",
                                    "[0.4, 6.0]", "route = \"direct\""));
  for (const char* command : {"check", "run"}) {
    const ProgramResult result =
        run_floe(folder, std::string(command) + " case.toml --allow-coarse");
    EXPECT_EQ(result.code, 3);
    EXPECT_THAT(result.error, HasSubstr("invalid omega = 6 rad/s (must be below 4.42945"));
    EXPECT_THAT(result.output, Not(HasSubstr("kept")));
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "case.out"));
}

}  // namespace
}  // namespace floe
