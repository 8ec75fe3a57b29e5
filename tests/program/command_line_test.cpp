#include "floe_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace floe {
namespace {

using test::kCaseText;
using test::ProgramResult;
using test::run_floe;
using test::TestFolder;
using test::with;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(Program, TellsItsVersionAndHelp) {
  const TestFolder folder;
  const ProgramResult version = run_floe(folder, "--version");
  EXPECT_EQ(version.code, 0);
  EXPECT_THAT(version.output, StartsWith("floe "));
  for (const char* arguments : {"--help", "run --help", "check --help", "mesh rectangle --help"}) {
    const ProgramResult help = run_floe(folder, arguments);
    EXPECT_EQ(help.code, 0) << arguments;
    EXPECT_THAT(help.output, HasSubstr("Usage: floe")) << arguments;
  }
  EXPECT_THAT(run_floe(folder, "--help").output, HasSubstr("floe run cases/table1.toml"));
}

TEST(Program, RefusesWrongCommandLinesWithTwo) {
  const TestFolder folder;
  folder.write("case.toml", kCaseText);
  const std::pair<const char*, const char*> table[] = {
      {"",
       "missing word after floe (must be one of run, check, converge, stats, report, status, "
       "export, "
       "merge, mesh, init, man, completion; floe --help tells more)"},
      {"rnu case.toml", "unknown command rnu (did you mean run?)"},
      {"run", "case is required"},
      {"run case.toml --bogus", "unknown flag --bogus (known are "},
      {"run case.toml --theads=3", "unknown flag --theads (did you mean --threads?)"},
      {"run --freh case.toml", "unknown flag --freh (did you mean --fresh?)"},
      {"run case.toml -threads 3", "unknown flag -threads (did you mean --threads?)"},
      {"check case.toml -o x", "unknown flag -o (known are "},
      {"--threads 2 run case.toml", "--threads before the command (belongs behind it; "},
      {"run case.toml b.toml", "unexpected word b.toml (floe run --help tells"},
      {"run -x.toml", "unknown flag -x.toml (known are "},
      {"run -- case.toml --fresh", "unexpected word --fresh (floe run --help tells"},
      {"run case.toml -o ''", "invalid -o =  (must be the name of a folder)"},
      {"run case.toml --memory", "missing value of --memory (floe run --help tells more)"},
      {"init new.toml --sea 2", "missing value of --sea (floe init --help tells more)"},
      {"export some.out -o zzz", "-o requires --format (floe export --help tells more)"},
      {"export some.out --length 4", "--length requires --format"},
      {"run case.toml --threads 1 --threads 2", "--threads given more than once"},
      {"mesh",
       "missing word after floe mesh (must be one of rectangle, disc, ring, lshape, modules; "},
      {"mesh rectange", "unknown word rectange (did you mean rectangle?)"},
      {"mesh rectangle --length x --width 1 --nx 2 --ny 2 -o a.msh",
       "invalid --length = x (must be a number)"},
      {"mesh rectangle --length 3 --width 1 --nx 2.5 --ny 2 -o a.msh",
       "invalid --nx = 2.5 (must be a whole number)"},
      {"mesh rectangle --length 3", "--width is required (floe mesh rectangle --help tells more)"},
      {"run case.toml --threads 0", "invalid --threads = 0 (must be 1 to 1024)"},
      {"run case.toml --threads -3", "invalid --threads = -3 (must be 1 to 1024)"},
      {"run case.toml --threads 100000", "invalid --threads = 100000 (must be 1 to 1024)"},
      {"run case.toml --threads two", "invalid --threads = two (must be 1 to 1024)"},
      {"run case.toml --memory much", "invalid --memory = much (must be a positive number"},
      {"run case.toml --memory -1G", "invalid --memory = -1G"},
      {"run case.toml --max-time soon", "invalid --max-time = soon (must be a positive number"},
      {"run case.toml --progress loud",
       "invalid --progress = loud (must be auto, plain, json or none)"},
      {"mesh rectangle --length 3 --width -1 --nx 2 --ny 2 -o a.msh",
       "invalid rectangle width = -1 m (must be positive)"},
      {"mesh rectangle --length 3 --width 1 --nx 0 --ny 2 -o a.msh", "must be at least 1"},
      {"run a.toml --shard 3/2", "invalid --shard = 3/2 (must be I/N with 1 <= I <= N, like 3/40)"},
      {"export some.out --format tecplot",
       "invalid --format = tecplot (must be netcdf, wamit or paraview)"},
      {"mesh disk", "unknown word disk (did you mean disc?)"},
      {"mesh disc --radius 0 --element-size 1 -o a.msh",
       "invalid disc radius = 0 m (must be positive)"},
      {"mesh disc --radius 1 -o a.msh", "--element-size is required"},
      {"mesh ring --inner-radius 5 --outer-radius 5 --element-size 1 -o a.msh",
       "invalid ring inner_radius = 5 m (must be less than outer_radius = 5 m)"},
      {"mesh lshape --length 10 --width 10 --cut-length 3.14159 --cut-width 5 --element-size 1 "
       "-o a.msh",
       "invalid lshape cut_length = 3.14159 m (must be a whole number of equal elements"},
      {"mesh modules --module-length 10 --module-width 10 --modules-x 2 --modules-y 0 --gap 1 "
       "--element-size 1 -o a.msh",
       "invalid modules_x, modules_y = 2, 0 (must be at least 1)"},
      {"mesh disc --radius 1e9 --element-size 1e-3 -o a.msh", "must be at most 1e8 in all"},
  };
  for (const auto& [arguments, message] : table) {
    const ProgramResult result = run_floe(folder, arguments);
    EXPECT_EQ(result.code, 2) << arguments;
    EXPECT_THAT(result.error, AllOf(StartsWith("floe: error: "), HasSubstr(message))) << arguments;
  }
  EXPECT_THAT(names_in(folder.path()), ElementsAre("case.toml"));
}

TEST(Program, RefusesWrongCasesWithThreeAndThePlace) {
  const TestFolder folder;
  folder.write("case.toml", with("58.5", "-3"));
  for (const char* command : {"run", "check"}) {
    const ProgramResult result = run_floe(folder, std::string(command) + " case.toml");
    EXPECT_EQ(result.code, 3);
    EXPECT_EQ(result.error,
              "floe: error: case.toml:2:9: invalid water.depth = -3 m (must be positive or inf)\n");
  }
  EXPECT_EQ(run_floe(folder, "run none.toml").error,
            "floe: error: none.toml: cannot read: No such file or directory\n");
  EXPECT_EQ(run_floe(folder, "run .").code, 3);
  ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(run_floe(folder, "run pipe").code, 3);
  EXPECT_THAT(names_in(folder.path()), ElementsAre("case.toml", "pipe"));
}

TEST(Program, RefusesAMissingMeshWithFour) {
  const TestFolder folder;
  folder.write("case.toml", with("rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }",
                                 "file = \"none.msh\""));
  EXPECT_EQ(run_floe(folder, "run case.toml").code, 4);
  folder.write("none.msh", "not a mesh");
  EXPECT_EQ(run_floe(folder, "run case.toml").code, 4);
  EXPECT_THAT(names_in(folder.path()), ElementsAre("case.toml", "none.msh"));
}

TEST(Program, RefusesCoarseMeshesUnlessAllowed) {
  const TestFolder folder;
  // 1.5 rad/s: 27 m waves against nodes 37.5 m apart
  folder.write("case.toml", with("[0.4, 0.5]", "[0.4, 1.5]"));
  for (const char* command : {"run", "check"}) {
    const ProgramResult result = run_floe(folder, std::string(command) + " case.toml");
    EXPECT_EQ(result.code, 3);
    EXPECT_THAT(result.error, HasSubstr("invalid mesh resolution = 0.73 nodes per wavelength at "
                                        "omega = 1.5 rad/s (1 of 2 frequencies)"));
    EXPECT_THAT(result.error, HasSubstr("--allow-coarse"));
  }
  const ProgramResult allowed = run_floe(folder, "check case.toml --allow-coarse");
  EXPECT_EQ(allowed.code, 0);
  EXPECT_THAT(allowed.output, HasSubstr("coarse mesh: 0.73 nodes per wavelength"));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("case.toml"));
}

TEST(Program, RefusesPointsThatLieOnNoPlate) {
  const TestFolder folder;
  for (const char* output : {"points = { P1 = [0, 31] }",
                             "lines = { c = { from = [0, 0], to = [151, 0], count = 3 } }"}) {
    folder.write("case.toml", kCaseText + "[output]\n" + output + "\n");
    for (const char* command : {"run", "check"}) {
      const ProgramResult result = run_floe(folder, std::string(command) + " case.toml");
      EXPECT_EQ(result.code, 3) << command << " " << output;
      EXPECT_THAT(result.error, HasSubstr("must lie on a plate; the mesh spans x = -150 … 150 m, "
                                          "y = -30 … 30 m)"));
    }
  }
  EXPECT_THAT(names_in(folder.path()), ElementsAre("case.toml"));
}

TEST(Program, RefusesModesThatTheMeshCannotHave) {
  const TestFolder folder;
  folder.write("case.toml", kCaseText + "[modes]\ncount = 56\n");  // 37 nodes, 111 unknowns
  for (const char* command : {"run", "check"}) {
    const ProgramResult result = run_floe(folder, std::string(command) + " case.toml");
    EXPECT_EQ(result.code, 3);
    EXPECT_THAT(result.error,
                StartsWith("floe: error: invalid modes.count = 56 (must be 3 to 55 "));
  }
  EXPECT_THAT(names_in(folder.path()), ElementsAre("case.toml"));
}

TEST(Program, RefusesTheLatticeOnAMeshThatIsNone) {
  const TestFolder folder;
  folder.write("case.toml",
               with("rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }",
                    "ring = { inner_radius = 50, outer_radius = 150, element_size = 40 }") +
                   "[solver]\nmethod = \"lattice\"\n");
  for (const char* command : {"run", "check"}) {
    const ProgramResult result = run_floe(folder, std::string(command) + " case.toml");
    EXPECT_EQ(result.code, 4);
    EXPECT_THAT(result.error, StartsWith("floe: error: method = lattice on this mesh (must have "));
  }
  EXPECT_THAT(names_in(folder.path()), ElementsAre("case.toml"));
}

TEST(Program, RefusesAPlateMeshThatLeavesOutWater) {
  const TestFolder folder;
  folder.write("case.toml", with("density = 256.25",
                                 "density = 256.25\nmesh = { rectangle = { length = 200.0, width = "
                                 "60.0, nx = 4, ny = 2 } }"));
  for (const char* command : {"run", "check"}) {
    const ProgramResult result = run_floe(folder, std::string(command) + " case.toml");
    EXPECT_EQ(result.code, 4);
    EXPECT_THAT(result.error, StartsWith("floe: error: invalid plate.mesh: node "));
    EXPECT_THAT(result.error, HasSubstr("(must cover all of [mesh])"));
  }
  EXPECT_THAT(names_in(folder.path()), ElementsAre("case.toml"));
}

TEST(Program, RefusesWhatExceedsTheMemoryWithSix) {
  const TestFolder folder;
  folder.write("case.toml", with("nx = 4, ny = 2", "nx = 100, ny = 40"));
  for (const char* command : {"run", "check"}) {
    const ProgramResult result =
        run_floe(folder, std::string(command) + " case.toml --memory 200M");
    EXPECT_EQ(result.code, 6);
    EXPECT_THAT(result.error, HasSubstr("invalid memory need = "));
    EXPECT_THAT(result.error, HasSubstr("(must be at most 210 MB; "));
  }
  EXPECT_THAT(names_in(folder.path()), ElementsAre("case.toml"));
}

TEST(Program, ChecksWithoutWritingAnything) {
  const TestFolder folder;
  folder.write("case.toml", kCaseText);
  const ProgramResult result = run_floe(folder, "check case.toml");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.error, IsEmpty());
  // (2·4 + 1)(2·2 + 1) - 4·2 nodes
  EXPECT_THAT(result.output, HasSubstr("37 nodes, 8 elements, 1 piece, 18000 m²"));
  EXPECT_THAT(result.output, HasSubstr("memory"));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("case.toml"));
}

TEST(Program, MakesMeshesThatItReads) {
  const TestFolder folder;
  const ProgramResult made = run_floe(
      folder, "mesh rectangle --length 300 --width 60 --nx 4 --ny 2 --grading 2 -o ./-p.msh");
  EXPECT_EQ(made.code, 0) << made.error;
  EXPECT_THAT(made.output, HasSubstr("37 nodes, 8 elements"));
  folder.write("case.toml", with("rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }",
                                 "file = \"-p.msh\""));
  EXPECT_THAT(run_floe(folder, "check case.toml").output,
              HasSubstr("37 nodes, 8 elements, 1 piece, 18000 m²"));
  EXPECT_EQ(run_floe(folder, "mesh rectangle --length 3 --width 1 --nx 1 --ny 1 -o no/a.msh").code,
            7);
}

TEST(Program, GivesTheSameNumbersInEveryLocale) {
  const TestFolder folder;
  folder.write("case.toml", kCaseText);
  EXPECT_EQ(run_floe(folder, "check case.toml", "LC_ALL=de_DE.UTF-8").output,
            run_floe(folder, "check case.toml", "LC_ALL=C").output);
}

}  // namespace
}  // namespace floe
