#include "floe_program.hpp"
#include "io/netcdf_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include <cmath>
#include <sstream>
#include <tuple>

namespace floe {
namespace {

using test::kCaseText;
using test::ProgramResult;
using test::run_floe;
using test::TestFolder;
using test::with;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kOutput = R"([modes]
count = 6
[output]
points = { P1 = [-150, -30], P5 = [0, 0] }
lines = { centreline = { from = [-150, 0], to = [150, 0], count = 5 } }
wave_points = { lee = [200, 0] }
quantities = ["deflection", "bending_moment_x", "pressure"]
)";

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

// Number of data rows, the header left out
int rows_in(const std::string& csv) {
  std::istringstream lines(csv);
  int rows = -1;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("#")) ++rows;
  return rows;
}

TEST(Run, StoresTheWholeResultOfATinyCase) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput);
  const ProgramResult result = run_floe(folder, "run tiny.toml");
  ASSERT_EQ(result.code, 0) << result.error;
  EXPECT_THAT(result.error, IsEmpty());
  EXPECT_THAT(result.output, HasSubstr("37 nodes, 8 elements, 1 piece"));
  EXPECT_THAT(result.output, HasSubstr("tiny.out"));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("tiny.out", "tiny.toml"));
  EXPECT_THAT(
      names_in(folder.path() / "tiny.out"),
      ElementsAre("dry_modes.csv", "exciting_force.csv", "fields", "fields.pvd",
                  "hydro_coefficients.csv", "rao_lines.csv", "rao_points.csv", "rao_quantities.csv",
                  "records", "result.nc", "run.json", "wave_points.csv"));
  EXPECT_EQ(rows_in(folder.read("tiny.out/dry_modes.csv")), 6);
  EXPECT_EQ(rows_in(folder.read("tiny.out/rao_points.csv")), 2 * 2 * 2);
  EXPECT_EQ(rows_in(folder.read("tiny.out/rao_lines.csv")), 2 * 2 * 5);
  EXPECT_EQ(rows_in(folder.read("tiny.out/rao_quantities.csv")), 2 * 2 * 2 * 3);
  EXPECT_EQ(rows_in(folder.read("tiny.out/wave_points.csv")), 2 * 2);
  EXPECT_EQ(rows_in(folder.read("tiny.out/hydro_coefficients.csv")), 2 * 36);
  EXPECT_EQ(rows_in(folder.read("tiny.out/exciting_force.csv")), 2 * 2 * 6);
  const auto run = nlohmann::json::parse(folder.read("tiny.out/run.json"));
  EXPECT_EQ(run.at("status"), "complete");
  ASSERT_EQ(run.at("frequencies").size(), 2u);
  EXPECT_EQ(run.at("frequencies").at(0).at("method"), "dense");
  EXPECT_LT(run.at("frequencies").at(0).at("true_residual").get<double>(), 1e-6);
  // The first heading, both frequencies
  EXPECT_EQ(names_in(folder.path() / "tiny.out/fields").size(), 2u);
}

const std::string kSeaSection = R"([sea_grid]
omega = { from = 0.4, to = 0.8 }
[[sea]]
name = "design"
spectrum = "bretschneider"
significant_height = 2.0
significant_period = 10.0
spreading = "cos2"
mean_heading_deg = [0, 40]
allow_truncation = true
)";

TEST(Run, TellsWhatASeaDoes) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput + kSeaSection);
  const ProgramResult result = run_floe(folder, "run tiny.toml --allow-coarse");
  ASSERT_EQ(result.code, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("sea design, mean heading 40°: 4√m0 = 1.998 m"));
  EXPECT_THAT(result.output, HasSubstr("of its m0 lie outside the frequencies that are computed"));
  EXPECT_THAT(folder.read("tiny.out/run.json"), HasSubstr("% of its peak where the frequencies"));
  // Two headings, two points, three quantities; five stations
  EXPECT_EQ(rows_in(folder.read("tiny.out/statistics_points.csv")), 2 * 2 * 3);
  EXPECT_EQ(rows_in(folder.read("tiny.out/design_values.csv")), 2 * 2 * 3);
  EXPECT_EQ(rows_in(folder.read("tiny.out/statistics_lines.csv")), 2 * 5);
  const auto run = nlohmann::json::parse(folder.read("tiny.out/run.json"));
  const int frequencies = run.at("seas").at("frequencies");
  EXPECT_EQ(rows_in(folder.read("tiny.out/spectra_points.csv")), 2 * 2 * 3 * frequencies);
  EXPECT_EQ(run.at("seas").at("solved").size(), run.at("seas").at("solved_frequencies"));
  EXPECT_THAT(folder.read("tiny.out/statistics.vtu"), HasSubstr("std_w_design_40"));
  for (const char* name : {"spectra_points.csv", "statistics.vtu"})
    EXPECT_THAT(run.at("files").get<std::vector<std::string>>(), testing::Contains(name));
  // --fresh takes them away again
  folder.write("tiny.toml", kCaseText + kOutput);
  ASSERT_EQ(run_floe(folder, "run tiny.toml --fresh").code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "tiny.out/statistics.vtu"));
}

const std::string kSeaFile = kSeaSection.substr(kSeaSection.find("[[sea]]"));

TEST(Stats, TellTheSameOfTheSameSeaWithoutSolving) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput + kSeaSection);
  ASSERT_EQ(run_floe(folder, "run tiny.toml --allow-coarse").code, 0);
  folder.write("storm.toml", kSeaFile);
  const ProgramResult result = run_floe(folder, "stats tiny.out --sea storm.toml");
  ASSERT_EQ(result.code, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("storm.out/ (6 files)"));
  const auto data_rows = [&](const std::string& file) {
    const std::string text = folder.read(file);
    return text.substr(text.find("\nsea,"));
  };
  for (const std::string name :
       {"spectra_points.csv", "statistics_points.csv", "design_values.csv", "statistics_lines.csv"})
    EXPECT_EQ(data_rows("storm.out/" + name), data_rows("tiny.out/" + name)) << name;
  EXPECT_EQ(folder.read("storm.out/statistics.vtu"), folder.read("tiny.out/statistics.vtu"));
  // Once more only on demand
  EXPECT_EQ(run_floe(folder, "stats tiny.out --sea storm.toml").code, 9);
  EXPECT_EQ(run_floe(folder, "stats tiny.out --sea storm.toml --fresh").code, 0);
}

TEST(Stats, TellTheSpectraOfAllNodesWhereTheCaseAsks) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput + "node_spectra = true\n" + kSeaSection);
  ASSERT_EQ(run_floe(folder, "run tiny.toml --allow-coarse").code, 0);
  folder.write("storm.toml", kSeaFile);
  ASSERT_EQ(run_floe(folder, "stats tiny.out --sea storm.toml").code, 0);
  ASSERT_GT(folder.read("storm.out/node_spectra.nc").size(), 1000u);
  const auto spectra = [&](const std::string& file) {
    return io::NetcdfFile::open(folder.path() / file).numbers("spectrum");
  };
  EXPECT_EQ(spectra("storm.out/node_spectra.nc"), spectra("tiny.out/node_spectra.nc"));
  const auto run = nlohmann::json::parse(folder.read("storm.out/run.json"));
  EXPECT_THAT(run.at("files").get<std::vector<std::string>>(),
              testing::Contains("node_spectra.nc"));
}

TEST(Stats, LeaveTheRunItselfAlone) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput + kSeaSection);
  ASSERT_EQ(run_floe(folder, "run tiny.toml --allow-coarse").code, 0);
  folder.write("storm.toml", kSeaFile);
  const std::string before = folder.read("tiny.out/run.json");
  const ProgramResult result =
      run_floe(folder, "stats tiny.out --sea storm.toml -o ./tiny.out --fresh");
  EXPECT_EQ(result.code, 2);
  EXPECT_THAT(result.error, HasSubstr("invalid -o = ./tiny.out (must not be the run itself)"));
  EXPECT_EQ(folder.read("tiny.out/run.json"), before);
}

TEST(Stats, NameWhatIsMissing) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput);
  ASSERT_EQ(run_floe(folder, "run tiny.toml").code, 0);
  folder.write("storm.toml", kSeaFile);
  folder.write("bad.toml", "[[sea]]\nname = \"a\"\n");
  folder.write("none.toml", "x = 1\n");
  const std::tuple<const char*, int, const char*> table[] = {
      {"stats tiny.out --sea storm.toml", 9, "holds no transfer functions for seas (run the case"},
      {"stats none --sea storm.toml", 9, "no result of floe in none: run.json cannot be read"},
      {"stats tiny.out --sea bad.toml", 5, "bad.toml:1:1: missing sea[0].spectrum"},
      {"stats tiny.out --sea none.toml", 5,
       "none.toml:1:1: unknown key x (known are sea, scatter)"},
      {"stats tiny.out --sea absent.toml", 5, "absent.toml: cannot read: No such file"},
      {"stats tiny.out", 2, "--sea is required"},
  };
  for (const auto& [arguments, code, message] : table) {
    const ProgramResult result = run_floe(folder, arguments);
    EXPECT_EQ(result.code, code) << arguments;
    EXPECT_THAT(result.error, HasSubstr(message));
  }
}

TEST(Stats, TellWhatIsExceededInManyYears) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput + kSeaSection);
  ASSERT_EQ(run_floe(folder, "run tiny.toml --allow-coarse").code, 0);
  folder.write("north.csv", "Hs\\Tz,8.5,10.5,12.5\n1.5,50,30,0\n3.5,4,10,6\n");
  const std::string scatter = R"([[scatter]]
name = "north"
file = "north.csv"
period_type = "Tz"
spectrum = "bretschneider"
spreading = "cos2"
mean_heading_deg = [0, 90]
heading_probability = [0.8, 0.2]
allow_truncation = true
)";
  folder.write("climate.toml", scatter);
  const ProgramResult result = run_floe(folder, "stats tiny.out --sea climate.toml");
  ASSERT_EQ(result.code, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("scatter north: 2 heights × 3 Tz, bretschneider"));
  EXPECT_THAT(result.output, HasSubstr("in 100 years deflection w "));
  // Two headings, three periods, two points, three quantities; three return periods
  EXPECT_EQ(rows_in(folder.read("climate.out/short_term.csv")), 2 * 3 * 2 * 3);
  ASSERT_EQ(rows_in(folder.read("climate.out/return_values.csv")), 2 * 3 * 3);
  EXPECT_GT(rows_in(folder.read("climate.out/long_term.csv")), 2 * 3 * 20);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "climate.out/statistics_points.csv"));
  const auto run = nlohmann::json::parse(folder.read("climate.out/run.json"));
  EXPECT_EQ(run.at("seas").at("scatter").at(0).at("scatter"), "north");
  EXPECT_EQ(run.at("files").size(), 4u);

  // With a sea beside it; and a table that is none
  folder.write("both.toml", scatter + kSeaFile);
  ASSERT_EQ(run_floe(folder, "stats tiny.out --sea both.toml").code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "both.out/statistics_points.csv"));
  const auto without_warnings = [](const std::string& table) {
    return table.substr(table.find("\nscatter,"));
  };
  EXPECT_EQ(without_warnings(folder.read("both.out/return_values.csv")),
            without_warnings(folder.read("climate.out/return_values.csv")));
  folder.write("north.csv", "Hs,8.5,10.5\n1.5,50\n");
  const ProgramResult ragged = run_floe(folder, "stats tiny.out --sea both.toml --fresh");
  EXPECT_EQ(ragged.code, 5);
  EXPECT_THAT(ragged.error, HasSubstr("north.csv:2: a row of 2 cells (must be 3"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "both.out/statistics_points.csv"));
}

TEST(Stats, NoticeADamagedRecord) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput + kSeaSection);
  ASSERT_EQ(run_floe(folder, "run tiny.toml --allow-coarse").code, 0);
  folder.write("storm.toml", kSeaFile);
  std::string record = folder.read("tiny.out/records/transfer_00002.rec");
  record[record.size() / 2] ^= 1;
  folder.write("tiny.out/records/transfer_00002.rec", record);
  const ProgramResult result = run_floe(folder, "stats tiny.out --sea storm.toml");
  EXPECT_EQ(result.code, 9);
  EXPECT_THAT(result.error, HasSubstr("transfer_00002.rec is damaged"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "storm.out"));
}

TEST(ReportCommand, WritesOnePageOfARun) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput + kSeaSection);
  ASSERT_EQ(run_floe(folder, "run tiny.toml --allow-coarse").code, 0);
  const ProgramResult result = run_floe(folder, "report tiny.out");
  if (result.code == 2) GTEST_SKIP() << result.error;  // built without the page
  ASSERT_EQ(result.code, 0) << result.error;
  const std::string page = folder.read("tiny.out/report.html");
  for (const char* what : {"\"design\"", "bending_moment_x", "significant_period = 10.0", "[water]",
                           "of its m0 lie outside"})
    EXPECT_THAT(page, HasSubstr(what));
  EXPECT_EQ(run_floe(folder, "report tiny.out -o other.html").code, 0);
  EXPECT_EQ(folder.read("other.html"), page);
  EXPECT_EQ(run_floe(folder, "report .").code, 9);
  // The page goes with the run that it shows
  ASSERT_EQ(run_floe(folder, "run tiny.toml --allow-coarse --fresh").code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "tiny.out/report.html"));
}

TEST(Run, RefusesASeaWhoseEnergyLiesElsewhere) {
  const TestFolder folder;
  std::string sea = kSeaSection;
  sea.replace(sea.find("allow_truncation = true"), 23, "");
  folder.write("tiny.toml", kCaseText + kOutput + sea);
  const ProgramResult result = run_floe(folder, "run tiny.toml --allow-coarse");
  EXPECT_EQ(result.code, 5);
  EXPECT_THAT(result.error, HasSubstr("sea design: "));
  EXPECT_THAT(result.error, HasSubstr("(at most 5 %; widen sea_grid.omega"));
}

TEST(Run, GivesTheSameBytesForAnyNumberOfThreads) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput);
  ASSERT_EQ(run_floe(folder, "run tiny.toml -o one --threads 1").code, 0);
  ASSERT_EQ(run_floe(folder, "run tiny.toml -o three --threads 3").code, 0);
  for (const std::string& name : names_in(folder.path() / "one")) {
    if (!name.ends_with(".csv")) continue;
    EXPECT_EQ(folder.read("one/" + name), folder.read("three/" + name)) << name;
  }
}

TEST(Run, KeepsAnEarlierResultUnlessFresh) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText);
  ASSERT_EQ(run_floe(folder, "run tiny.toml -o out").code, 0);
  folder.write("out/notes.txt", "mine");
  const ProgramResult again = run_floe(folder, "run tiny.toml -o out");
  EXPECT_EQ(again.code, 9);
  EXPECT_THAT(again.error, HasSubstr("--fresh"));
  EXPECT_EQ(run_floe(folder, "run tiny.toml -o out --fresh").code, 0);
  EXPECT_EQ(folder.read("out/notes.txt"), "mine");
}

TEST(Run, RefusesPathsItCannotWriteToBeforeComputing) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText);
  folder.write("file", "");
  for (const char* path : {"file", "file/out", "none/out", "/proc/floe.out"}) {
    const ProgramResult result = run_floe(folder, std::string("run tiny.toml -o ") + path);
    EXPECT_EQ(result.code, 7) << path;
    EXPECT_THAT(result.error, HasSubstr("cannot write to " + std::string(path) + ": ")) << path;
    EXPECT_THAT(result.output, testing::Not(HasSubstr("modes"))) << path;
  }
}

TEST(Run, WaitsForNobodyInABusyDirectory) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText);
  std::filesystem::create_directory(folder.path() / "out");
  const int lock = ::open((folder.path() / "out/run.lock").c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_EQ(::flock(lock, LOCK_EX | LOCK_NB), 0);
  const ProgramResult result = run_floe(folder, "run tiny.toml -o out");
  EXPECT_EQ(result.code, 10);
  EXPECT_THAT(result.error, HasSubstr("another run holds out"));
  ::close(lock);
  EXPECT_EQ(run_floe(folder, "run tiny.toml -o out").code, 0);
}

TEST(Run, SurvivesClosedAndBrokenOutput) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText);
  EXPECT_EQ(run_floe(folder, "run tiny.toml -o a >&-").code, 0);
  EXPECT_EQ(run_floe(folder, "run tiny.toml -o b >/dev/full").code, 0);
  EXPECT_EQ(run_floe(folder, "run tiny.toml -o c; echo $? >code; } | head -c 1; { true").code, 0);
  EXPECT_EQ(folder.read("code"), "0\n");
  EXPECT_EQ(folder.read("a/rao_points.csv"), folder.read("c/rao_points.csv"));
}

TEST(Run, RefusesAPlateWithoutStiffnessWithThree) {
  const TestFolder folder;
  folder.write("case.toml", with("thickness = 2.0", "thickness = 1e-300"));
  const ProgramResult result = run_floe(folder, "run case.toml");
  EXPECT_EQ(result.code, 3);
  EXPECT_THAT(result.error, HasSubstr("floe: error: invalid plate bending rigidity = 0 N m"));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("case.toml"));
}

TEST(Run, TellsAFullDiskWithSeven) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText + kOutput);
  const ProgramResult result = run_floe(folder, "run tiny.toml -o out", "ulimit -f 2;");
  EXPECT_EQ(result.code, 7) << result.error;
  EXPECT_THAT(result.error, HasSubstr("File too large"));
}

TEST(Run, StopsCleanlyAtASignal) {
  const TestFolder folder;
  // Enough frequencies to be still running when the signal comes
  folder.write("long.toml", with("[0.4, 0.5]", "{ from = 0.2, to = 0.6, count = 20000 }"));
  for (const auto& [name, code] : {std::pair{"INT", 130}, std::pair{"TERM", 143}}) {
    const ProgramResult coded =
        run_floe(folder, "run long.toml --fresh",
                 std::string("timeout --preserve-status -s ") + name + " 2");
    EXPECT_EQ(coded.code, code);
    EXPECT_THAT(coded.error, HasSubstr(code == 130 ? "interrupted" : "terminated"));
    EXPECT_THAT(coded.output, HasSubstr("of 20000 frequencies in long.out/"));
    const auto run = nlohmann::json::parse(folder.read("long.out/run.json"));
    EXPECT_NE(run.at("status"), "complete");
    EXPECT_EQ(rows_in(folder.read("long.out/exciting_force.csv")),
              static_cast<int>(run.at("frequencies").size()) * 2 * 30);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "long.out/run.lock"));
  }
}

TEST(Run, SpeaksJsonLinesToPrograms) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText);
  const ProgramResult result = run_floe(folder, "run tiny.toml --progress=json");
  ASSERT_EQ(result.code, 0) << result.error;
  std::istringstream lines(result.output);
  int frequencies = 0;
  for (std::string line; std::getline(lines, line);)
    if (nlohmann::json::parse(line).at("event") == "frequency") ++frequencies;
  EXPECT_EQ(frequencies, 2);
  EXPECT_THAT(run_floe(folder, "run tiny.toml --fresh --progress=none").output, IsEmpty());
}

TEST(Run, NoticesMoreThreadsThanProcessors) {
  const TestFolder folder;
  folder.write("tiny.toml", kCaseText);
  const ProgramResult result = run_floe(folder, "run tiny.toml --threads 1000");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.output, HasSubstr("1000 threads asked for, the process may use "));
}

}  // namespace
}  // namespace floe
