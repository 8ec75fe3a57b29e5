#include "csv.hpp"
#include "floe_program.hpp"

#include <floe/io/case_file.hpp>
#include <floe/io/report.hpp>
#include <floe/mesh/rectangle.hpp>
#include <floe/plate/dry_modes.hpp>
#include <floe/plate/mindlin.hpp>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

// A plate by regions, and one that another program has made, through the real program
namespace floe {
namespace {

using test::kCaseText;
using test::ProgramResult;
using test::run_floe;
using test::TestFolder;
using testing::HasSubstr;

const std::string kMesh = "rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }";
const std::string kMaterial =
    "thickness = 2.0\nyoungs_modulus = 1.19e10\npoisson_ratio = 0.13\ndensity = 256.25\n";
const std::string kEnd =
    "[modes]\ncount = 8\n[output]\npoints = { P1 = [-150, -30], P5 = [0, 0], P6 = [75, 10] }\n";

std::string case_of(const std::string& plate, const std::string& mesh, const std::string& end) {
  std::string text = kCaseText;
  text.replace(text.find(kMaterial), kMaterial.size(), plate);
  text.replace(text.find(kMesh), kMesh.size(), mesh);
  return text + end;
}

// Deflections at the points, or values of quantities
std::vector<double> values_of(const TestFolder& folder, const std::string& table,
                              const std::string& column) {
  return test::read_csv(folder.path() / table).numbers(column);
}

void expect_equal(const std::vector<double>& found, const std::vector<double>& expected,
                  double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  double largest = 0.0;
  for (const double value : expected) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], tolerance * largest) << i;
}

// The plate of the case as a Gmsh file whose left and right half are physical surfaces
std::string halves_msh() {
  const mesh::Q8Mesh mesh =
      mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = 4, .ny = 2});
  std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"left\"\n2 2 "
      "\"right\"\n$EndPhysicalNames\n$Nodes\n" +
      std::to_string(mesh.node_count()) + "\n";
  for (Index n = 0; n < mesh.node_count(); ++n)
    text += fmt::format("{} {} {} 0\n", n + 1, mesh.nodes()(0, n), mesh.nodes()(1, n));
  text += "$EndNodes\n$Elements\n" + std::to_string(mesh.element_count()) + "\n";
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const int group = mesh.element_nodes(e).row(0).mean() < 0.0 ? 1 : 2;
    text += fmt::format("{} 16 2 {} 1", e + 1, group);
    for (int a = 0; a < 8; ++a) text += fmt::format(" {}", mesh.elements()(a, e) + 1);
    text += "\n";
  }
  return text + "$EndElements\n";
}

TEST(Regions, OfTheSamePropertiesRunAsTheUniformPlate) {
  const TestFolder folder;
  folder.write("halves.msh", halves_msh());
  const std::string end = kEnd + "quantities = [\"bending_moment_x\", \"surface_stress_x\"]\n";
  folder.write("one.toml", case_of(kMaterial, "file = \"halves.msh\"", end));
  folder.write("two.toml", case_of(kMaterial + "[[plate.region]]\nname = \"left\"\n"
                                               "[[plate.region]]\nname = \"right\"\n",
                                   "file = \"halves.msh\"", end));
  for (const char* name : {"one", "two"}) {
    const ProgramResult run = run_floe(folder, std::string("run ") + name + ".toml");
    ASSERT_EQ(run.code, 0) << run.error;
  }
  for (const char* column : {"re_w", "im_w"})
    expect_equal(values_of(folder, "two.out/rao_points.csv", column),
                 values_of(folder, "one.out/rao_points.csv", column), 1e-9);
  // P5 lies on the line between the halves, where only one of them counts
  for (const char* point : {"P1", "P6"}) {
    const auto moments = [&](const std::string& name) {
      return test::read_csv(folder.path() / (name + ".out/rao_quantities.csv"))
          .where("point", point)
          .numbers("re");
    };
    expect_equal(moments("two"), moments("one"), 1e-9);
  }
  EXPECT_EQ(run_floe(folder, "run two.toml --resume").code, 0);
}

TEST(Regions, ThatDifferChangeTheAnswer) {
  const TestFolder folder;
  folder.write("halves.msh", halves_msh());
  const auto run = [&](const std::string& name, const std::string& region) {
    folder.write(name + ".toml", case_of(kMaterial + region, "file = \"halves.msh\"", kEnd));
    const ProgramResult result = run_floe(folder, "run " + name + ".toml");
    EXPECT_EQ(result.code, 0) << result.error;
    return values_of(folder, name + ".out/dry_modes.csv", "omega");
  };
  const auto uniform = run("a", "");
  const auto stiff = run("b", "[[plate.region]]\nname = \"left\"\nthickness = 4.0\n");
  const auto thick = run("c",
                         "[[plate.region]]\nname = \"left\"\nthickness = 4.0\n"
                         "[[plate.region]]\nname = \"right\"\nthickness = 4.0\n");
  // ω ~ t for a plate that is thin everywhere; half of it makes less of a difference
  EXPECT_NEAR(thick[3] / uniform[3], 2.0, 0.01);
  EXPECT_GT(stiff[3], 1.01 * uniform[3]);
  EXPECT_LT(stiff[3], 0.99 * thick[3]);
}

const std::string kDirect = "[solver]\nroute = \"direct\"\n";

// The direct route knows regions too: of the same properties, the uniform plate; of others, what
// half of all modes give. What these leave out is stiff: far below the difference of the two plates
TEST(Regions, AreKnownToTheDirectRoute) {
  const TestFolder folder;
  folder.write("halves.msh", halves_msh());
  const auto run = [&](const std::string& name, const std::string& region, std::string end) {
    folder.write(name + ".toml", case_of(kMaterial + region, "file = \"halves.msh\"", end));
    const ProgramResult result = run_floe(folder, "run " + name + ".toml");
    EXPECT_EQ(result.code, 0) << result.error;
    return values_of(folder, name + ".out/rao_points.csv", "abs_w");
  };
  const std::string moments = kEnd + "quantities = [\"surface_stress_x\"]\n" + kDirect;
  const auto uniform = run("one", "", moments);
  expect_equal(run("two", "[[plate.region]]\nname = \"left\"\n", moments), uniform, 1e-6);
  const std::string stiff = "[[plate.region]]\nname = \"left\"\nthickness = 4.0\n";
  const auto direct = run("three", stiff, moments);
  std::string many = kEnd;
  many.replace(many.find("count = 8"), 9, "count = 55");
  const auto modal = run("four", stiff, many);
  double difference = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < uniform.size(); ++i) {
    difference = std::max(difference, std::abs(direct[i] - uniform[i]));
    largest = std::max(largest, direct[i]);
  }
  // A route that did not know the regions would be off by the whole difference; on eight elements
  // the routes themselves differ by some per cent of the deflection, as reciprocity does
  expect_equal(direct, modal, 0.25 * difference / largest);
}

// τ = 6 Mxy / t² with the thickness at the point, not that of the rest of the plate
TEST(Regions, GiveTheirThicknessToTheStressOfVonMises) {
  const TestFolder folder;
  folder.write("halves.msh", halves_msh());
  const std::string end = kEnd +
                          "quantities = [\"surface_stress_x\", \"surface_stress_y\", "
                          "\"twisting_moment\"]\n[output.combinations]\n"
                          "left = { von_mises = \"P1\" }\nright = { von_mises = \"P6\" }\n";
  folder.write("case.toml",
               case_of(kMaterial + "[[plate.region]]\nname = \"left\"\nthickness = 4.0\n",
                       "file = \"halves.msh\"", end));
  const Case data = io::read_case(folder.path() / "case.toml").data;
  ASSERT_EQ(data.relations.combinations.size(), 2u);
  EXPECT_DOUBLE_EQ(data.relations.combinations[0].terms[2].factor, 6.0 / 16.0);
  EXPECT_DOUBLE_EQ(data.relations.combinations[1].terms[2].factor, 6.0 / 4.0);
}

TEST(Regions, AreSeenInTheReport) {
  if (!io::report_available()) GTEST_SKIP() << "built without the report";
  const TestFolder folder;
  folder.write("halves.msh", halves_msh());
  folder.write("case.toml",
               case_of(kMaterial + "[[plate.region]]\nname = \"left\"\nthickness = 4.0\n",
                       "file = \"halves.msh\"", kEnd));
  ASSERT_EQ(run_floe(folder, "run case.toml").code, 0);
  ASSERT_EQ(run_floe(folder, "report case.out").code, 0);
  EXPECT_THAT(folder.read("case.out/report.html"), HasSubstr("\"thickness\":[2.0,4.0]"));
}

TEST(Regions, AreRefusedWithThePlaceWhereTheyDoNotFit) {
  const TestFolder folder;
  folder.write("halves.msh", halves_msh());
  const std::pair<const char*, const char*> table[] = {
      {"[[plate.region]]\nname = \"middle\"\n",
       "invalid plate.region.name = middle (must be a group of the mesh's elements, one of left, "
       "right)"},
      {"[[plate.region]]\nthickness = 1.0\n", "plate.region[0].name"},
      {"[[plate.region]]\nname = \"left\"\nthickness = -1.0\n",
       "invalid plate.region[0].thickness = -1 m (must be positive)"},
      {"[[plate.region]]\nname = \"left\"\ndensity = 2000.0\n", "or the plate sinks"},
      {"[[plate.region]]\nname = \"left\"\nthicknes = 1.0\n", "thickness"},
      {"[[plate.region]]\nname = \"left\"\n[[plate.region]]\nname = \"left\"\n",
       "repeated plate.region[1].name"},
      {"region = 3\n", "must be tables [[plate.region]]"},
  };
  for (const auto& [region, message] : table) {
    folder.write("case.toml", case_of(kMaterial + region, "file = \"halves.msh\"", kEnd));
    for (const char* command : {"check", "run"}) {
      const ProgramResult result = run_floe(folder, std::string(command) + " case.toml");
      EXPECT_EQ(result.code, 3) << region;
      EXPECT_THAT(result.error, HasSubstr(message)) << region;
    }
  }
  folder.write("case.toml",
               case_of(kMaterial + "[[plate.region]]\nname = \"left\"\n", kMesh, kEnd));
  EXPECT_THAT(run_floe(folder, "check case.toml").error, HasSubstr("of which it has none"));
}

std::string sparse_text(const SparseMatrix& matrix) {
  std::string text = fmt::format("%%MatrixMarket matrix coordinate real symmetric\n% lower\n{} {} ",
                                 matrix.rows(), matrix.cols());
  std::string entries;
  Index count = 0;
  for (Index column = 0; column < matrix.cols(); ++column)
    for (SparseMatrix::InnerIterator it(matrix, column); it; ++it)
      if (it.row() >= column) {
        entries += fmt::format("{} {} {}\n", it.row() + 1, column + 1, it.value());
        ++count;
      }
  return text + std::to_string(count) + "\n" + entries;
}

std::string dense_text(const MatXd& matrix) {
  std::string text = fmt::format("%%MatrixMarket matrix array real general\n{} {}\n", matrix.rows(),
                                 matrix.cols());
  for (const double value : matrix.reshaped()) text += fmt::format("{}\n", value);
  return text;
}

class Structure : public testing::Test {
 protected:
  Structure() {
    const plate::PlateMatrices plate = plate::assemble_plate(mesh_, properties_);
    const plate::DryModes modes = plate::dry_modes(mesh_, properties_, {.count = 8});
    folder_.write("K.mtx", sparse_text(plate.stiffness));
    folder_.write("M.mtx", sparse_text(plate.mass));
    folder_.write("modes.mtx", dense_text(modes.shape));
    folder_.write("omega.mtx", dense_text(modes.omega));
  }
  ProgramResult run(const std::string& plate, const std::string& end = kEnd,
                    const std::string& mesh = kMesh) {
    folder_.write("case.toml", case_of(plate, mesh, end));
    return run_floe(folder_, "run case.toml --fresh");
  }

  TestFolder folder_;
  mesh::Q8Mesh mesh_ = mesh::make_rectangle({.length = 300.0, .width = 60.0, .nx = 4, .ny = 2});
  plate::PlateProperties properties_{
      .thickness = 2.0, .youngs_modulus = 1.19e10, .poisson_ratio = 0.13, .density = 256.25};
};

// The files carry every digit; the elastic modes are computed once more from K and M to 1e-10
TEST_F(Structure, OfItsOwnMatricesOrModesAnswersAsThePlate) {
  ASSERT_EQ(run(kMaterial).code, 0);
  std::map<std::string, std::vector<double>> expected;
  for (const char* column : {"re_w", "im_w", "abs_w"})
    expected[column] = values_of(folder_, "case.out/rao_points.csv", column);
  for (const char* plate :
       {"structure = { stiffness = \"K.mtx\", mass = \"M.mtx\" }\n",
        "structure = { modes = \"modes.mtx\", omega = \"omega.mtx\", mass = \"M.mtx\" }\n",
        "structure = { modes = \"modes.mtx\", omega = \"omega.mtx\" }\n"}) {
    const ProgramResult result = run(plate);
    ASSERT_EQ(result.code, 0) << plate << result.error;
    for (const auto& [column, values] : expected)
      expect_equal(values_of(folder_, "case.out/rao_points.csv", column), values, 1e-8);
    EXPECT_EQ(run_floe(folder_, "run case.toml --resume").code, 0);
    EXPECT_EQ(run_floe(folder_, "export case.out --format wamit --all-dofs").code, 0);
    if (io::report_available()) {
      EXPECT_EQ(run_floe(folder_, "report case.out").code, 0);
    }
  }
}

TEST_F(Structure, IsRefusedWithFourWhereItDoesNotFit) {
  const std::string matrices = "structure = { stiffness = \"K.mtx\", mass = \"M.mtx\" }\n";
  const std::string modes = "structure = { modes = \"modes.mtx\", omega = \"omega.mtx\" }\n";
  const auto expect_four = [&](const ProgramResult& result, const std::string& message) {
    EXPECT_EQ(result.code, 4) << message;
    EXPECT_THAT(result.error, HasSubstr(message));
  };
  // Another mesh
  const std::string finer = "rectangle = { length = 300.0, width = 60.0, nx = 5, ny = 2 }";
  expect_four(run(matrices, kEnd, finer),
              "invalid plate.structure.stiffness of 111 × 111 entries "
              "(must be 135 × 135, three for each of the mesh's 45 nodes)");
  expect_four(run(modes, kEnd, finer), "invalid plate.structure.modes of 111 rows (must be 135");
  folder_.write("case.toml", case_of(matrices, finer, kEnd));
  EXPECT_EQ(run_floe(folder_, "check case.toml").code, 4);
  // Files that are missing or none
  expect_four(run("structure = { stiffness = \"none.mtx\", mass = \"M.mtx\" }\n"),
              "none.mtx: cannot read");
  folder_.write("K.mtx", "3 3 1\n1 1 1\n");
  expect_four(run(matrices), "K.mtx:1: no Matrix Market file");
}

TEST_F(Structure, RefusesWhatIsNotAvailableThen) {
  const std::string matrices = "structure = { stiffness = \"K.mtx\", mass = \"M.mtx\" }\n";
  const std::pair<std::string, std::string> table[] = {
      {kMaterial + matrices, "unused plate.thickness (plate.structure takes its place)"},
      {"structure = { stiffness = \"K.mtx\" }\n",
       "must hold stiffness and mass, or modes and omega"},
      {"structure = { stiffness = \"K.mtx\", mass = \"M.mtx\", omega = \"omega.mtx\" }\n",
       "must hold stiffness and mass, or modes and omega"},
  };
  for (const auto& [plate, message] : table) {
    const ProgramResult result = run(plate);
    EXPECT_EQ(result.code, 3) << plate;
    EXPECT_THAT(result.error, HasSubstr(message));
  }
  const ProgramResult direct = run(matrices, kEnd + kDirect);
  EXPECT_EQ(direct.code, 3);
  EXPECT_THAT(direct.error, HasSubstr("invalid plate.structure with solver.route = \"direct\""));
  const ProgramResult forces = run(matrices, kEnd + "quantities = [\"shear_force_x\"]\n");
  EXPECT_EQ(forces.code, 3);
  EXPECT_THAT(forces.error, HasSubstr("shear_force_x (must follow from deflections or pressures"));
  EXPECT_EQ(run(matrices, kEnd + "quantities = [\"acceleration\", \"pressure\"]\n").code, 0);
}

}  // namespace
}  // namespace floe
