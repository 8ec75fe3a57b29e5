#include "test_case.hpp"

#include <floe/io/case_file.hpp>
#include <floe/numeric/error.hpp>
#include <floe/wave/dispersion.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <numbers>

namespace floe::io {
namespace {

using test::kCaseText;
using test::TestFolder;
using test::with;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

CaseFile read_text(const std::string& text) {
  const TestFolder folder;
  return read_case(folder.write("case.toml", text));
}

// The message without the folder: "case.toml:2:9: invalid …"
std::string refusal(const std::string& text) {
  const TestFolder folder;
  const auto path = folder.write("case.toml", text);
  try {
    read_case(path);
  } catch (const Error& error) {
    const std::string message = error.what();
    const std::string before = folder.path().string() + "/";
    EXPECT_THAT(message, StartsWith(before));
    return message.substr(before.size());
  }
  return "accepted";
}

TEST(CaseFile, TakesOverEveryKey) {
  const Case data = read_text(R"(title = "Plate"
[water]
depth = inf
density = 1000
gravity = 9.8
[plate]
thickness = 3.0
youngs_modulus = 2e10
poisson_ratio = 0.3
density = 300.0
shear_correction = 0.8
loss_factor = 0.02
mesh = { rectangle = { length = 10, width = 5, nx = 2, ny = 1 } }
[mesh]
rectangle = { length = 10.0, width = 5.0, nx = 4, ny = 2, grading = 2 }
[modes]
count = 12
[waves]
omega = { from = 1.0, to = 2.0, count = 3 }
heading_deg = [0, -45.5]
[solver]
method = "dense"
route = "modal"
tolerance = 1e-4
[output]
points = { P10 = [-5, -2.5], P2 = [5, 2.5] }
lines = { centreline = { from = [-5, 0], to = [5, 0], count = 11 } }
wave_points = { lee = [20, 0] }
quantities = ["deflection", "bending_moment_x"]
fields = [{ omega = 1.5, heading_deg = -45.5 }]
)")
                        .data;
  EXPECT_EQ(data.title, "Plate");
  EXPECT_TRUE(std::isinf(data.water.depth));
  EXPECT_EQ(data.water.density, 1000.0);
  EXPECT_EQ(data.water.gravity, 9.8);
  EXPECT_EQ(data.plate.thickness, 3.0);
  EXPECT_EQ(data.plate.youngs_modulus, 2e10);
  EXPECT_EQ(data.plate.poisson_ratio, 0.3);
  EXPECT_EQ(data.plate.density, 300.0);
  EXPECT_EQ(data.plate.shear_correction, 0.8);
  EXPECT_EQ(data.plate.loss_factor, 0.02);
  ASSERT_EQ(data.plate_mesh.size(), 1u);
  EXPECT_EQ(std::get<mesh::RectangleOptions>(data.plate_mesh[0]).nx, 2);
  EXPECT_EQ(std::get<mesh::RectangleOptions>(data.mesh).grading, 2.0);
  EXPECT_EQ(data.mode_count, 12);
  EXPECT_THAT(data.omega, ElementsAre(1.0, 1.5, 2.0));
  EXPECT_THAT(data.heading_deg, ElementsAre(0.0, -45.5));
  EXPECT_EQ(data.method, SolverMethod::kDense);
  EXPECT_EQ(data.tolerance, 1e-4);
  ASSERT_EQ(data.points.size(), 2u);
  EXPECT_EQ(data.points[0].name, "P10") << "points keep the order of the file";
  EXPECT_EQ(data.points[1].position, Point2(5.0, 2.5));
  ASSERT_EQ(data.lines.size(), 1u);
  EXPECT_EQ(data.lines[0].count, 11);
  EXPECT_EQ(data.lines[0].to, Point2(5.0, 0.0));
  EXPECT_EQ(data.wave_points.at(0).name, "lee");
  EXPECT_THAT(data.quantities,
              ElementsAre(response::Quantity::kDeflection, response::Quantity::kBendingMomentX));
  ASSERT_EQ(data.fields.size(), 1u);
  EXPECT_EQ(data.fields[0].omega, 1.5);
  EXPECT_EQ(data.fields[0].heading_deg, -45.5);
}

TEST(CaseFile, FillsInTheDefaults) {
  const CaseFile file = read_text(kCaseText);
  EXPECT_EQ(file.data.title, "");
  EXPECT_EQ(file.data.water.density, 1025.0);
  EXPECT_EQ(file.data.water.gravity, 9.81);
  EXPECT_EQ(file.data.plate.shear_correction, 5.0 / 6.0);
  EXPECT_EQ(file.data.mode_count, 30);
  EXPECT_EQ(file.data.method, SolverMethod::kAuto);
  EXPECT_EQ(file.data.tolerance, 1e-6);
  EXPECT_TRUE(file.data.points.empty());
  EXPECT_THAT(file.data.quantities, ElementsAre(response::Quantity::kDeflection));
  EXPECT_TRUE(file.notices.empty());
  EXPECT_TRUE(file.warnings.empty());
}

TEST(CaseFile, AcceptsByteOrderMarkAndCarriageReturns) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : kCaseText) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(read_text(text).data.water.depth, 58.5);
}

TEST(CaseFile, TurnsEveryAxisIntoFrequencies) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const auto first = [](const std::string& line) {
    return read_text(with("omega = [0.4, 0.5]", line)).data.omega.at(0);
  };
  EXPECT_EQ(first("period = [10.0]"), kTurn / 10.0);
  EXPECT_EQ(first("freq = [0.1]"), kTurn * 0.1);
  // The dispersion relation read directly: omega² = g k tanh kh, to a few roundings
  const double k = 0.02, omega = std::sqrt(9.81 * k * std::tanh(k * 58.5));
  EXPECT_NEAR(first("wavenumber = [0.02]"), omega, 1e-14);
  EXPECT_NEAR(first("wavelength = [314.1592653589793]"), omega, 1e-14);
}

TEST(CaseFile, SortsFrequenciesWithANotice) {
  const CaseFile file = read_text(with("[0.4, 0.5]", "[0.5, 0.4, 0.5]"));
  EXPECT_THAT(file.data.omega, ElementsAre(0.4, 0.5));
  EXPECT_THAT(file.notices,
              ElementsAre("waves.omega sorted", "waves.omega: 1 given twice dropped"));
  EXPECT_TRUE(read_text(with("omega = [0.4, 0.5]", "period = [5, 10]")).notices.empty())
      << "rising periods are in order";
}

TEST(CaseFile, SuspectsHeadingsInRadians) {
  const CaseFile file = read_text(with("[0, 30]", "[0.7853981633974483, 1.5707963267948966]"));
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_THAT(file.warnings[0], HasSubstr("did you mean degrees?"));
  EXPECT_TRUE(read_text(with("[0, 30]", "[0, 1, 2]")).warnings.empty());
}

TEST(CaseFile, TakesMeshPathsFromItsOwnFolder) {
  const TestFolder folder;
  std::filesystem::create_directory(folder.path() / "mesh files é");
  folder.write("mesh files é/plate.msh", "");
  const auto path =
      folder.write("case.toml", with("rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }",
                                     "file = \"mesh files é/../mesh files é/plate.msh\""));
  const auto mesh = std::get<std::filesystem::path>(read_case(path).data.mesh);
  EXPECT_TRUE(std::filesystem::equivalent(mesh, folder.path() / "mesh files é/plate.msh"));
}

TEST(CaseFile, TreatsMinusZeroAsZero) {
  const Case data = read_text(with("[0, 30]", "[-0.0, 0.0, 30]")).data;
  ASSERT_EQ(data.heading_deg.size(), 2u);
  EXPECT_FALSE(std::signbit(data.heading_deg[0]));
}

struct Refused {
  const char* from;
  const char* to;
  const char* message;
};

TEST(CaseFile, NamesPlaceValueAndRemedyOfEveryFault) {
  const Refused table[] = {
      // Ranges
      {"58.5", "-3", "case.toml:2:9: invalid water.depth = -3 m (must be positive or inf)"},
      {"58.5", "0", "case.toml:2:9: invalid water.depth = 0 m (must be positive or inf)"},
      {"58.5", "-0.0", "case.toml:2:9: invalid water.depth = -0 m (must be positive or inf)"},
      {"58.5", "nan", "case.toml:2:9: invalid water.depth = nan m (must be at least 0.001 or inf)"},
      {"58.5", "-inf", "case.toml:2:9: invalid water.depth = -inf m (must be positive or inf)"},
      {"58.5", "1e-310",
       "case.toml:2:9: invalid water.depth = 1e-310 m (must be at least 0.001 or inf; "},
      {"58.5", "1e400", "case.toml:2:"},
      {"= 2.0", "= 0", "case.toml:4:13: invalid plate.thickness = 0 m (must be positive)"},
      {"= 2.0", "= inf", "case.toml:4:13: invalid plate.thickness = inf m (must be positive)"},
      {"1.19e10", "-1.0",
       "case.toml:5:18: invalid plate.youngs_modulus = -1 N/m² (must be positive)"},
      {"0.13", "0.5",
       "case.toml:6:17: invalid plate.poisson_ratio = 0.5 (must be greater than -1 and less than "
       "0.5)"},
      {"0.13", "-1",
       "case.toml:6:17: invalid plate.poisson_ratio = -1 (must be greater than -1 and less than "
       "0.5)"},
      {"256.25", "1025.0",
       "case.toml:7:11: invalid plate.density = 1025 kg/m³ (must be less than water.density = 1025 "
       "kg/m³, or the plate sinks)"},
      {"nx = 4", "nx = 0",
       "case.toml:9:50: invalid mesh.rectangle.nx = 0 (must be a whole number from 1 to "
       "100000000)"},
      {"nx = 4", "nx = 4.5", "case.toml:9:50: invalid mesh.rectangle.nx = 4.5 (must be a whole"},
      {"nx = 4", "nx = 4.0", "case.toml:9:50: invalid mesh.rectangle.nx = 4.0 (must be a whole"},
      {"ny = 2", "ny = 2, grading = 0.5",
       "case.toml:9:71: invalid mesh.rectangle.grading = 0.5 (must be 1 to 100)"},
      {"[0.4, 0.5]", "[0.4, 0]",
       "case.toml:11:15: invalid waves.omega[1] = 0 rad/s (must be positive)"},
      {"[0.4, 0.5]", "[0.4, inf]",
       "case.toml:11:15: invalid waves.omega[1] = inf rad/s (must be positive)"},
      {"[0.4, 0.5]", "[]", "case.toml:11:9: invalid waves.omega = [] (must not be empty)"},
      {"omega = [0.4, 0.5]", "period = [0]",
       "case.toml:11:11: invalid waves.period[0] = 0 s (must be positive)"},
      {"omega = [0.4, 0.5]", "wavelength = [1e-9]",
       "case.toml:11:15: invalid waves.wavelength = 1e-09 m (must mean a frequency of 0.0001 to "
       "1000 rad/s)"},
      {"[0.4, 0.5]", "{ from = 1, to = 0.5, count = 3 }",
       "case.toml:11:26: invalid waves.omega.to = 0.5 rad/s (must be greater than from)"},
      {"[0.4, 0.5]", "{ from = 1, to = 2 }",
       "case.toml:11:9: missing waves.omega.count (must be a whole number from 2 to 100000)"},
      {"[0.4, 0.5]", "{ from = 1, to = 2, count = 1 }",
       "case.toml:11:37: invalid waves.omega.count = 1 (must be a whole number from 2 to 100000)"},
      {"[0, 30]", "[400]",
       "case.toml:12:16: invalid waves.heading_deg[0] = 400 ° (must be -360 to 360)"},
      {"[water]", "title = \"a\\u001b[2J\"\n[water]",
       "case.toml:1:9: invalid title = \"a?[2J\" (must be one line without control characters)"},
      // Types and units
      {"58.5", "\"58,5\"", "case.toml:2:9: invalid water.depth = \"58,5\" (must be a number in m)"},
      {"58.5", "[58.5]", "case.toml:2:9: invalid water.depth = a list (must be a number in m)"},
      {"58.5", "99999999999999999999", "case.toml:2:"},
      {"[0.4, 0.5]", "0.4",
       "case.toml:11:9: invalid waves.omega = 0.4 (must be a list of numbers in rad/s or { from = "
       "…, to = …, count = … })"},
      {"[0.4, 0.5]", "[true]",
       "case.toml:11:10: invalid waves.omega[0] = true (must be a number in rad/s)"},
      // Names
      {"depth", "dpeth", "case.toml:2:1: unknown key water.dpeth (did you mean water.depth?)"},
      {"depth", "colour",
       "case.toml:2:1: unknown key water.colour (known are depth, density, gravity)"},
      {"[waves]", "[wave]", "case.toml:10:2: unknown section wave (did you mean waves?)"},
      {"ny = 2", "ny = 2, nz = 1",
       "case.toml:9:61: unknown key mesh.rectangle.nz (did you mean mesh.rectangle.nx?)"},
      {"rectangle", "rectangel",
       "case.toml:9:1: unknown key mesh.rectangel (did you mean mesh.rectangle?)"},
      // Missing and ambiguous
      {"depth = 58.5", "",
       "case.toml:1:1: missing water.depth (required: a number in m, must be at least 0.001 or "
       "inf)"},
      {"omega = [0.4, 0.5]\n", "",
       "case.toml:10:1: missing waves (must hold one of omega, period, freq, wavenumber, "
       "wavelength)"},
      {"omega = [0.4, 0.5]", "omega = [0.4]\nperiod = [10]",
       "case.toml:12:10: ambiguous waves.period beside waves.omega (must be exactly one of omega, "
       "period, freq, wavenumber, wavelength)"},
      {"heading_deg = [0, 30]", "", "case.toml:10:1: missing waves.heading_deg (must be a list"},
      {"rectangle =", "file = \"a.msh\"\nrectangle =",
       "case.toml:8:1: ambiguous mesh (must hold one of rectangle, disc, ring, lshape, modules, "
       "file)"},
      // Files
      {"rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }", "file = \"none.msh\"",
       "case.toml:9:8: invalid mesh.file = \"none.msh\" (cannot read: No such file or directory)"},
      {"rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }", "file = \".\"",
       "case.toml:9:8: invalid mesh.file = \".\" (must be a regular file)"},
  };
  for (const Refused& fault : table)
    EXPECT_THAT(refusal(with(fault.from, fault.to)), StartsWith(fault.message))
        << fault.from << " -> " << fault.to;
}

TEST(CaseFile, NamesFaultsOfTheOptionalSections) {
  const std::pair<const char*, const char*> table[] = {
      {"[modes]\ncount = 2", "case.toml:14:9: invalid modes.count = 2 (must be a whole number"},
      {"[solver]\nmethod = \"magic\"",
       "case.toml:14:10: invalid solver.method = \"magic\" (must be auto or dense or lattice or "
       "pfft or fmm)"},
      {"[solver]\nmethod = \"ptff\"",
       "case.toml:14:10: invalid solver.method = \"ptff\" (must be auto or dense or lattice or "
       "pfft or fmm; did you mean pfft?)"},
      {"[solver]\nroute = \"fast\"",
       "case.toml:14:9: invalid solver.route = \"fast\" (must be modal or direct)"},
      {"[solver]\nroute = \"direct\"\n[sea_grid]\ntolerance = 1e-3",
       "case.toml:15:1: invalid sea_grid with solver.route = \"direct\" (seas need"},
      {"[solver]\ntolerance = 1e-12",
       "case.toml:14:13: invalid solver.tolerance = 1e-12 (must be 1e-9 to 1e-1)"},
      {"[sea_grid]\ntolerance = 1",
       "case.toml:14:13: invalid sea_grid.tolerance = 1 (must be 1e-6 to 0.1)"},
      {"[sea_grid]\nomega = { from = 2, to = 1 }",
       "case.toml:14:26: invalid sea_grid.omega.to = 1 rad/s (must be greater than from)"},
      {"[output]\npoints = { P1 = [0] }",
       "case.toml:14:17: invalid output.points.P1 = a list of 1 (must be two numbers [x, y] in m)"},
      {"[output]\npoints = { P1 = [0, nan] }",
       "case.toml:14:21: invalid output.points.P1[1] = nan m (must be finite)"},
      {"[output]\npoints = { \"=cmd()\" = [0, 0] }",
       "case.toml:14:12: invalid name in output.points = \"=cmd()\" (must be 1 to 64"},
      {"[output]\npoints = { \"a,b\" = [0, 0] }",
       "case.toml:14:12: invalid name in output.points = \"a,b\" (must be"},
      {"[output]\npoints = { \"a\\nb\" = [0, 0] }",
       "case.toml:14:12: invalid name in output.points = \"a?b\" (must be"},
      {"[output]\nlines = { c = { from = [0, 0], to = [1, 0], count = 1 } }",
       "case.toml:14:53: invalid output.lines.c.count = 1 (must be"},
      {"[output]\nlines = { c = { from = [0, 0], to = [0, 0], count = 3 } }",
       "case.toml:14:37: invalid output.lines.c.to = [0, 0] (must differ from "
       "output.lines.c.from)"},
      {"[output]\nquantities = [\"bending_moment\"]",
       "case.toml:14:15: invalid output.quantities[0] = \"bending_moment\" (did you mean "
       "bending_moment_x?)"},
      {"[output]\nfields = [{ omega = 0.45, heading_deg = 0 }]",
       "case.toml:14:21: invalid output.fields[0].omega = 0.45 (must be one of the frequencies of "
       "[waves])"},
      {"[output]\nfields = [{ omega = 0.4, heading_deg = 1 }]",
       "case.toml:14:40: invalid output.fields[0].heading_deg = 1 (must be one of "
       "waves.heading_deg)"},
      {"[water]", "case.toml:13:"},
      {"a = ", "case.toml:13:"},
      {"\"\\xff\"", "case.toml:13:"},
  };
  for (const auto& [text, message] : table)
    EXPECT_THAT(refusal(kCaseText + text + "\n"), StartsWith(message)) << text;
}

TEST(CaseFile, SurvivesFilesThatAreNoCase) {
  EXPECT_THAT(refusal(""), HasSubstr("the file is empty"));
  EXPECT_THAT(refusal(" \r\n\t"), HasSubstr("the file is empty"));
  EXPECT_THAT(refusal(std::string("a = \"\0\"", 8)), StartsWith("case.toml:1:"));
  EXPECT_THAT(refusal("a = " + std::string(20000, '[')), StartsWith("case.toml:1:"));
  EXPECT_THAT(refusal("a = \"\xff\xfe\""), StartsWith("case.toml:1:"));
  EXPECT_THAT(refusal("a = f\nb = 1\n"), testing::Not(HasSubstr("\n")));
  std::string noise;
  unsigned state = 12345;
  for (int i = 0; i < 300'000; ++i) {
    state = state * 1664525u + 1013904223u;
    noise += static_cast<char>(state >> 24);
  }
  EXPECT_THAT(refusal(noise), StartsWith("case.toml:1:"));
}

TEST(CaseFile, RefusesAnythingButARegularFileWithoutBlocking) {
  const TestFolder folder;
  EXPECT_THROW(read_case(folder.path() / "none.toml"), InputError);
  EXPECT_THROW(read_case(folder.path()), InputError);
  ASSERT_EQ(mkfifo((folder.path() / "pipe.toml").c_str(), 0600), 0);
  EXPECT_THROW(read_case(folder.path() / "pipe.toml"), InputError);
  EXPECT_THROW(read_case("/dev/zero"), InputError);
}

TEST(CaseFile, RefusesHugeFilesBeforeReadingThem) {
  const TestFolder folder;
  const auto path = folder.write("case.toml", "");
  std::filesystem::resize_file(path, std::uintmax_t{5} << 30);  // sparse
  try {
    read_case(path);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("invalid file size = 5368709120 bytes"));
  }
}

TEST(CaseFile, AsksForABudgetWhenFrequenciesAreTooMany) {
  const TestFolder folder;
  const auto path =
      folder.write("case.toml", with("[0.4, 0.5]", "{ from = 1, to = 2, count = 10000000 }"));
  EXPECT_THROW(read_case(path), BudgetError);
}

TEST(NearestName, ForgivesSwapsAndOmissionsButNotOtherWords) {
  const std::vector<std::string> known = {"depth", "density", "gravity"};
  EXPECT_EQ(nearest_name("dpeth", known), "depth");
  EXPECT_EQ(nearest_name("desity", known), "density");
  EXPECT_EQ(nearest_name("gravitation", known), "");
  EXPECT_EQ(nearest_name("colour", known), "");
}

}  // namespace
}  // namespace floe::io
