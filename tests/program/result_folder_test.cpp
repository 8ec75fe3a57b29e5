#include "floe_program.hpp"
#include "record_version.hpp"
#include "sanitized.hpp"
#include "stored_products.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

// Result folders in any state that a night may leave, and runs that want the same one.
namespace floe {
namespace {

using test::expect_same_products;
using test::kCaseText;
using test::ProgramResult;
using test::run_floe;
using test::TestFolder;
using test::with;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kRest = R"([modes]
count = 6
[output]
points = { P1 = [-150, -30] }
)";

const std::string kResume = "run case.toml --allow-coarse --resume -o ";

void copy_run(const TestFolder& folder, const std::string& from, const std::string& to) {
  std::filesystem::remove_all(folder.path() / to);
  std::filesystem::copy(folder.path() / from, folder.path() / to,
                        std::filesystem::copy_options::recursive);
}

void store_run(const TestFolder& folder, const std::string& name) {
  folder.write("case.toml", kCaseText + kRest);
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o " + name).code, 0);
}

TEST(ResultFolder, WithResultsIsRefusedByName) {
  const TestFolder folder;
  store_run(folder, "out");
  const ProgramResult again = run_floe(folder, "run case.toml --allow-coarse -o out");
  EXPECT_EQ(again.code, 9);
  EXPECT_THAT(again.error, AllOf(HasSubstr("--resume"), HasSubstr("--fresh")));
  // Records alone are results, too
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out"))
    if (entry.is_regular_file()) std::filesystem::remove(entry.path());
  EXPECT_EQ(run_floe(folder, "run case.toml --allow-coarse -o out").code, 9);
}

TEST(ResultFolder, WithoutItsManifestIsRefusedUntilFresh) {
  const TestFolder folder;
  store_run(folder, "whole");
  for (const char* manifest : {"", "{\"program\": \"floe\", \"opti", "{}"}) {
    copy_run(folder, "whole", "out");
    folder.write("out/records/manifest.json", manifest);
    if (std::string(manifest).empty())
      std::filesystem::remove(folder.path() / "out/records/manifest.json");
    const std::string before = folder.read("out/run.json");
    const ProgramResult resumed = run_floe(folder, kResume + "out");
    EXPECT_EQ(resumed.code, 9) << manifest;
    EXPECT_THAT(resumed.error, AllOf(HasSubstr("manifest.json"), HasSubstr("--fresh")));
    EXPECT_EQ(folder.read("out/run.json"), before);
    EXPECT_EQ(run_floe(folder, "run case.toml --allow-coarse -o out --fresh").code, 0);
    expect_same_products(folder, "whole", "out");
  }
}

TEST(ResultFolder, WithoutItsAccountGoesOn) {
  const TestFolder folder;
  store_run(folder, "whole");
  copy_run(folder, "whole", "out");
  std::filesystem::remove(folder.path() / "out/run.json");
  std::filesystem::remove(folder.path() / "out/rao_points.csv");
  folder.write("out/notes.txt", "mine");
  ASSERT_EQ(run_floe(folder, kResume + "out").code, 0);
  EXPECT_EQ(folder.read("out/rao_points.csv"), folder.read("whole/rao_points.csv"));
  // And can be replaced: what the manifest implies goes, the rest stays
  std::filesystem::remove(folder.path() / "out/run.json");
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o out --fresh").code, 0);
  EXPECT_EQ(folder.read("out/notes.txt"), "mine");
  std::filesystem::remove(folder.path() / "out/notes.txt");
  expect_same_products(folder, "whole", "out");
}

TEST(ResultFolder, OfANewerFloeIsRefused) {
  const TestFolder folder;
  store_run(folder, "whole");
  copy_run(folder, "whole", "out");
  const std::string record = test::with_version(folder.read("out/records/frequency_00002.rec"), 3);
  folder.write("out/records/frequency_00002.rec", record);
  const ProgramResult newer = run_floe(folder, kResume + "out");
  EXPECT_EQ(newer.code, 9);
  EXPECT_THAT(newer.error,
              AllOf(HasSubstr("frequency_00002.rec has the format version"), HasSubstr("--fresh")));
  EXPECT_EQ(folder.read("out/records/frequency_00002.rec"), record) << "left alone";

  // A manifest of a later format, or of another solver
  copy_run(folder, "whole", "out");
  auto manifest = nlohmann::ordered_json::parse(folder.read("whole/records/manifest.json"));
  manifest["format"] = manifest["format"].get<int>() + 1;
  folder.write("out/records/manifest.json", manifest.dump());
  EXPECT_THAT(run_floe(folder, kResume + "out").error, HasSubstr("has the format version"));
  manifest["format"] = manifest["format"].get<int>() - 1;
  manifest["solver"] = 0;
  folder.write("out/records/manifest.json", manifest.dump());
  EXPECT_THAT(run_floe(folder, kResume + "out").error, HasSubstr("another case: /solver differ"));
  // Another release with the same solver goes on
  manifest["solver"] =
      nlohmann::ordered_json::parse(folder.read("whole/records/manifest.json"))["solver"];
  manifest["version"] = "0.0.1";
  folder.write("out/records/manifest.json", manifest.dump());
  EXPECT_EQ(run_floe(folder, kResume + "out").code, 0);
}

TEST(ResultFolder, SetsARecordOfAnotherPlaceOrCaseAside) {
  const TestFolder folder;
  store_run(folder, "whole");
  std::string other = kCaseText + kRest;
  other.replace(other.find("thickness = 2.0"), 15, "thickness = 2.5");
  folder.write("other.toml", other);
  ASSERT_EQ(run_floe(folder, "run other.toml --allow-coarse -o other").code, 0);
  for (const char* source : {"whole/records/frequency_00002.rec",
                             "other/records/frequency_00001.rec", "whole/records/modes.rec"}) {
    copy_run(folder, "whole", "out");
    folder.write("out/records/frequency_00001.rec", folder.read(source));
    const ProgramResult result = run_floe(folder, kResume + "out");
    ASSERT_EQ(result.code, 0) << result.error;
    EXPECT_THAT(
        result.output,
        HasSubstr("frequency_00001.rec is damaged (moved to records/bad/frequency_00001.rec)"));
    EXPECT_EQ(folder.read("out/records/bad/frequency_00001.rec"), folder.read(source));
    expect_same_products(folder, "whole", "out");
    // It goes with the rest
    ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o out --fresh").code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/records/bad"));
  }
}

TEST(ResultFolder, TakesHarmlessChangesAndNamesTheOthers) {
  const TestFolder folder;
  store_run(folder, "whole");
  const std::pair<const char*, const char*> changes[] = {
      {"heading_deg = [0, 30]", "heading_deg = [0, 31]"},
      {"nx = 4", "nx = 5"},
      {"depth = 58.5", "depth = 50"},
      {"count = 6", "count = 7"}};
  const char* const keys[] = {"/options/waves/heading_deg/1", "/options/mesh/rectangle/nx",
                              "/options/water/depth", "/options/modes/count"};
  for (std::size_t i = 0; i < std::size(changes); ++i) {
    std::string other = kCaseText + kRest;
    const std::string from = changes[i].first;
    other.replace(other.find(from), from.size(), changes[i].second);
    folder.write("case.toml", other);
    const ProgramResult result = run_floe(folder, kResume + "whole");
    EXPECT_EQ(result.code, 9);
    EXPECT_THAT(result.error, HasSubstr(keys[i]));
  }
  folder.write("case.toml", "title = \"new\" # and a comment\n" + kCaseText + kRest);
  const ProgramResult result =
      run_floe(folder, "run case.toml --resume -o whole --threads 2 --memory 3G");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_THAT(folder.read("whole/rao_points.csv"), HasSubstr("# new\n"));
}

TEST(ResultFolder, NoticesAMeshFileThatWasEdited) {
  const TestFolder folder;
  const auto make_plate = [&](int nx) {
    return run_floe(folder, "mesh rectangle --length 300 --width 60 --nx " + std::to_string(nx) +
                                " --ny 2 -o plate.msh")
        .code;
  };
  ASSERT_EQ(make_plate(8), 0);
  folder.write(
      "case.toml",
      with("density = 256.25", "density = 256.25\nmesh = { file = \"plate.msh\" }") + kRest);
  ASSERT_EQ(run_floe(folder, "run case.toml --allow-coarse -o out").code, 0);
  ASSERT_EQ(make_plate(10), 0);
  const ProgramResult result = run_floe(folder, kResume + "out");
  EXPECT_EQ(result.code, 9);
  EXPECT_THAT(result.error, HasSubstr("/input_hashes/plate.mesh.file differ"));
}

// A file of a measured sea: one spectrum over frequencies
void write_measured(const TestFolder& folder, double height) {
  io::NetcdfFile file = io::NetcdfFile::create(folder.path() / "sea.nc");
  const std::vector<double> frequency = {0.05, 0.07, 0.09, 0.11},
                            density = {0.0, height, 0.5 * height, 0.0};
  file.add_dimension("freq", frequency.size());
  file.add_numbers("freq", {"freq"}, frequency);
  file.add_attribute("freq", "units", "Hz");
  file.add_numbers("efth", {"freq"}, density);
  file.add_attribute("efth", "units", "m2 s");
  file.close();
}

TEST(ResultFolder, NoticesSeasThatWereEdited) {
  const TestFolder folder;
  const std::string head = R"([sea_grid]
omega = { from = 0.35, to = 0.65 }
[[sea]]
name = "own"
mean_heading_deg = [0]
spreading = "cos2"
allow_truncation = true
)";
  // The same energy in another order, so that its words are the same
  const std::string one = head +
                          "spectrum = \"table\"\nomega = [0.3, 0.4, 0.5, 0.6]\n"
                          "density = [0, 1, 2, 0]\n",
                    other = head +
                            "spectrum = \"table\"\nomega = [0.3, 0.4, 0.5, 0.6]\n"
                            "density = [0, 2, 1, 0]\n";
  folder.write("case.toml", kCaseText + kRest + one);
  const ProgramResult first = run_floe(folder, "run case.toml --allow-coarse -o table");
  ASSERT_EQ(first.code, 0) << first.error;
  folder.write("case.toml", kCaseText + kRest + one + "# a comment\n");
  EXPECT_EQ(run_floe(folder, kResume + "table").code, 0);
  folder.write("case.toml", kCaseText + kRest + other);
  const ProgramResult edited = run_floe(folder, kResume + "table");
  EXPECT_EQ(edited.code, 9);
  EXPECT_THAT(edited.error, HasSubstr("/input_hashes/sea differ"));

  // And a file that the case names
  folder.write("case.toml",
               kCaseText + kRest + head + "spectrum = \"measured\"\nfile = \"sea.nc\"\n");
  write_measured(folder, 8.0);
  const ProgramResult measured = run_floe(folder, "run case.toml --allow-coarse -o measured");
  ASSERT_EQ(measured.code, 0) << measured.error;
  EXPECT_EQ(run_floe(folder, kResume + "measured").code, 0);
  write_measured(folder, 8.000001);
  const ProgramResult changed = run_floe(folder, kResume + "measured");
  EXPECT_EQ(changed.code, 9);
  EXPECT_THAT(changed.error, HasSubstr("/input_hashes/sea[0].file"));
}

TEST(ResultFolder, TakesInputFilesFromAnywhere) {
  const TestFolder folder;
  std::filesystem::create_directories(folder.path() / "a");
  ASSERT_EQ(
      run_floe(folder, "mesh rectangle --length 300 --width 60 --nx 4 --ny 2 -o a/plate.msh").code,
      0);
  folder.write("a/case.toml", with("rectangle = { length = 300.0, width = 60.0, nx = 4, ny = 2 }",
                                   "file = \"plate.msh\"") +
                                  kRest);
  ASSERT_EQ(run_floe(folder, "run a/case.toml --allow-coarse -o out").code, 0);
  std::filesystem::rename(folder.path() / "a", folder.path() / "b");
  const ProgramResult moved = run_floe(folder, "run b/case.toml --allow-coarse --resume -o out");
  EXPECT_EQ(moved.code, 0) << moved.error;
  ASSERT_EQ(
      run_floe(folder, "mesh rectangle --length 301 --width 60 --nx 4 --ny 2 -o b/plate.msh").code,
      0);
  const ProgramResult edited = run_floe(folder, "run b/case.toml --allow-coarse --resume -o out");
  EXPECT_EQ(edited.code, 9);
  EXPECT_THAT(edited.error, HasSubstr("/mesh_hash differ"));
}

TEST(ResultFolder, IsHeldByOneOfTwentyRunsThatStartAtOnce) {
  const TestFolder folder;
  folder.write("case.toml", with("[0.4, 0.5]", "{ from = 0.2, to = 0.6, count = 100000 }"));
  std::string starts;
  for (int i = 0; i < 20; ++i)
    starts += "('" FLOE_PROGRAM
              "' run case.toml --allow-coarse --progress=none -o out "
              "--threads 1 --max-time 6s 2>error" +
              std::to_string(i) + "; echo $? >>codes) & ";
  ASSERT_EQ(run_floe(folder, "--version >version; " + starts + " wait").code, 0);
  std::istringstream codes(folder.read("codes"));
  std::map<int, int> count;
  for (int code = 0; codes >> code;) ++count[code];
  EXPECT_EQ(count[75], 1);
  EXPECT_EQ(count[10], 19);
  bool named = false;
  for (int i = 0; i < 20; ++i)
    named =
        named || folder.read("error" + std::to_string(i)).find("another run holds out (process") !=
                     std::string::npos;
  EXPECT_TRUE(named);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/run.lock"));
}

TEST(ResultFolder, WithoutLocksIsUsedWithAWarning) {
  const TestFolder folder;
  folder.write("case.toml", kCaseText);
  const ProgramResult result = run_floe(folder, "run case.toml --allow-coarse",
                                        test::preloading(FLOE_FAULT_SHIM) + "FLOE_NO_LOCKS=1");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("the file system has no locks"));
  EXPECT_THAT(run_floe(folder, "run case.toml --allow-coarse --fresh").output,
              Not(HasSubstr("locks")));
}

TEST(Signals, OfABatchSystemStopWithSeventyFiveAndAHangUpWith129) {
  const TestFolder folder;
  folder.write("case.toml", with("[0.4, 0.5]", "{ from = 0.2, to = 0.6, count = 20000 }"));
  for (const auto& [name, code] : {std::pair{"USR1", 75}, std::pair{"HUP", 129}}) {
    const ProgramResult result =
        run_floe(folder, "run case.toml --allow-coarse --fresh",
                 std::string("timeout --preserve-status -s ") + name + " 2");
    EXPECT_EQ(result.code, code) << result.error;
    EXPECT_THAT(result.output, HasSubstr("of 20000 frequencies in case.out/"));
  }
}

TEST(Signals, GivenTwiceLeaveAtOnceAndKeepTheRecords) {
  const TestFolder folder;
  // Seconds a frequency: the first signal waits for it, the second does not
  folder.write("case.toml",
               with("nx = 4, ny = 2", "nx = 80, ny = 16") + "[solver]\nmethod = \"dense\"\n");
  const ProgramResult result =
      run_floe(folder,
               "run case.toml --progress=none & run=$!; while [ ! -e case.out/records/modes.rec ]; "
               "do :; done; sleep 0.3; kill -INT $run; sleep 0.4; kill -INT $run; wait $run");
  EXPECT_EQ(result.code, 130);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "case.out/records/modes.rec"));
  EXPECT_EQ(result.error.find("interrupted"), std::string::npos) << "it had no time to say so";
}

}  // namespace
}  // namespace floe
