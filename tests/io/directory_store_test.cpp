#include "fabricated_results.hpp"
#include "test_case.hpp"

#include <floe/estimate.hpp>
#include <floe/io/directory_store.hpp>
#include <floe/numeric/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace floe::io {
namespace {

using test::small_case;
using test::small_mesh;
using test::small_modes;
using test::small_result;
using test::TestFolder;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

// Rows of a CSV text, comment lines left out
std::vector<std::vector<std::string>> rows_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    std::vector<std::string> cells(1);
    for (const char c : line)
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    rows.push_back(cells);
  }
  return rows;
}

void store_all(const std::filesystem::path& directory, Existing existing = Existing::kRefuse) {
  const mesh::Q8Mesh mesh = small_mesh();
  DirectoryStore store(directory, existing);
  store.begin(small_case(), mesh, estimate(small_case(), mesh, nullptr, 1));
  store.modes(small_modes(), mesh);
  for (const double omega : small_case().omega) store.frequency(small_result(omega));
  store.finish({{"radiation", 1.5, 1e6}});
}

std::vector<std::string> names_in(const std::filesystem::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(DirectoryStore, WritesTheTablesOfTheContract) {
  const TestFolder folder;
  store_all(folder.path() / "out");
  const auto rows = [&](const char* name) {
    return rows_of(folder.read(std::string("out/") + name));
  };

  const auto modes = rows("dry_modes.csv");
  EXPECT_THAT(modes[0], ElementsAre("mode", "omega"));
  EXPECT_THAT(modes[1], ElementsAre("1", "0"));
  EXPECT_THAT(modes[4], ElementsAre("4", "0.3333333333333333"));

  const auto points = rows("rao_points.csv");
  EXPECT_THAT(points[0],
              ElementsAre("omega", "heading_deg", "point", "x", "y", "re_w", "im_w", "abs_w"));
  ASSERT_EQ(points.size(), 1u + 2 * 2 * 2);
  EXPECT_THAT(points[4], ElementsAre("0.4", "30", "P2", "0", "0", "1.4", "1.1", testing::_));

  const auto lines = rows("rao_lines.csv");
  EXPECT_THAT(lines[0],
              ElementsAre("omega", "heading_deg", "line", "s", "x", "y", "re_w", "im_w", "abs_w"));
  ASSERT_EQ(lines.size(), 1u + 2 * 2 * 5);
  EXPECT_THAT(lines[2],
              ElementsAre("0.4", "0", "centreline", "10", "-10", "0", "1.4", "0.1", testing::_));

  const auto quantities = rows("rao_quantities.csv");
  EXPECT_THAT(quantities[0],
              ElementsAre("omega", "heading_deg", "point", "quantity", "re", "im", "abs"));
  ASSERT_EQ(quantities.size(), 1u + 2 * 2 * 2 * 2);
  EXPECT_THAT(quantities[2], ElementsAre("0.4", "0", "P1", "pressure", "400", "100", testing::_));

  const auto waves = rows("wave_points.csv");
  EXPECT_THAT(waves[0], ElementsAre("omega", "heading_deg", "point", "x", "y", "re", "im", "abs"));
  EXPECT_THAT(waves[1], ElementsAre("0.4", "0", "lee", "60", "0", "0.4", "0.1", testing::_));

  const auto hydro = rows("hydro_coefficients.csv");
  EXPECT_THAT(hydro[0], ElementsAre("omega", "mode_i", "mode_j", "added_mass", "damping"));
  ASSERT_EQ(hydro.size(), 1u + 2 * 16);
  EXPECT_THAT(hydro[2], ElementsAre("0.4", "1", "2", "0.4", "1.1"));

  const auto forces = rows("exciting_force.csv");
  EXPECT_THAT(forces[0], ElementsAre("omega", "heading_deg", "mode", "re", "im"));
  EXPECT_THAT(forces.back(), ElementsAre("0.5", "30", "4", "3.5", "1.1"));
}

TEST(DirectoryStore, WritesNumbersThatReadBackExactly) {
  const TestFolder folder;
  store_all(folder.path() / "out");
  const auto rows = rows_of(folder.read("out/rao_points.csv"));
  const MatXcd expected = small_result(0.4).point_deflection;
  for (Index h = 0; h < 2; ++h)
    for (Index i = 0; i < 2; ++i) {
      const auto& row = rows[static_cast<std::size_t>(1 + 2 * h + i)];
      EXPECT_EQ(std::stod(row[5]), expected(i, h).real());
      EXPECT_EQ(std::stod(row[6]), expected(i, h).imag());
      EXPECT_EQ(std::stod(row[7]), std::abs(expected(i, h)));
    }
}

TEST(DirectoryStore, WritesEqualRunsEqually) {
  const TestFolder folder;
  ::setenv("SOURCE_DATE_EPOCH", "0", 1);  // result.nc tells when it was made
  store_all(folder.path() / "a");
  store_all(folder.path() / "b");
  ::unsetenv("SOURCE_DATE_EPOCH");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path() / "a")) {
    if (!entry.is_regular_file() || entry.path().filename() == "run.json") continue;
    const std::string name = entry.path().lexically_relative(folder.path() / "a").string();
    EXPECT_EQ(folder.read("a/" + name), folder.read("b/" + name)) << name;
    if (name.ends_with(".csv")) {
      EXPECT_EQ(folder.read("a/" + name).find(folder.path().string()), std::string::npos);
    }
  }
}

TEST(DirectoryStore, TellsTheRunInJson) {
  const TestFolder folder;
  store_all(folder.path() / "out");
  const auto run = nlohmann::json::parse(folder.read("out/run.json"));
  EXPECT_EQ(run.at("status"), "complete");
  EXPECT_EQ(run.at("method"), "dense");
  EXPECT_EQ(run.at("nodes"), small_mesh().node_count());
  EXPECT_EQ(run.at("mesh").at("elements"), 8);
  EXPECT_FALSE(run.at("mesh").at("hash").get<std::string>().empty());
  EXPECT_EQ(run.at("options").at("water").at("depth"), 20.0);
  EXPECT_EQ(run.at("options").at("mesh").at("rectangle").at("nx"), 4);
  EXPECT_EQ(run.at("stages").at(0).at("stage"), "radiation");
  EXPECT_GT(run.at("peak_memory").get<double>(), 0.0);
  ASSERT_EQ(run.at("frequencies").size(), 2u);
  for (const char* key : {"omega", "method", "iterations", "applications", "true_residual",
                          "kernel_error", "reciprocity_error", "energy_error", "seconds"})
    EXPECT_TRUE(run.at("frequencies").at(0).contains(key)) << key;
  std::vector<std::string> listed = run.at("files");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path() / "out"))
    if (entry.is_regular_file()) {
      const auto name = entry.path().lexically_relative(folder.path() / "out").string();
      EXPECT_THAT(listed, Contains(name));
    }
}

TEST(DirectoryStore, KeepsHostileTitlesOnOneCommentLine) {
  const TestFolder folder;
  const mesh::Q8Mesh mesh = small_mesh();
  Case data = small_case();
  data.title = "<script>\n0.4,\"=cmd()\"";
  DirectoryStore store(folder.path() / "out");
  store.begin(data, mesh, estimate(data, mesh, nullptr, 1));
  store.modes(small_modes(), mesh);
  for (const double omega : data.omega) store.frequency(small_result(omega));
  store.finish({});
  EXPECT_EQ(rows_of(folder.read("out/rao_points.csv"))[0][0], "omega");
  EXPECT_EQ(nlohmann::json::parse(folder.read("out/run.json")).at("options").at("title"),
            data.title);
}

TEST(DirectoryStore, ShowsTablesOnlyWhenTheyAreComplete) {
  const TestFolder folder;
  const mesh::Q8Mesh mesh = small_mesh();
  DirectoryStore store(folder.path() / "out");
  store.begin(small_case(), mesh, estimate(small_case(), mesh, nullptr, 1));
  store.modes(small_modes(), mesh);
  store.frequency(small_result(0.4));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/rao_points.csv"));
  EXPECT_EQ(nlohmann::json::parse(folder.read("out/run.json")).at("status"), "running");
  store.stop("interrupted");
  EXPECT_EQ(rows_of(folder.read("out/rao_points.csv")).size(), 1u + 4);
  EXPECT_EQ(nlohmann::json::parse(folder.read("out/run.json")).at("status"), "interrupted");
}

TEST(DirectoryStore, LeavesNothingOfARunWithoutResults) {
  const TestFolder folder;
  {
    DirectoryStore untouched(folder.path() / "a");
    const mesh::Q8Mesh mesh = small_mesh();
    DirectoryStore store(folder.path() / "b");
    store.begin(small_case(), mesh, estimate(small_case(), mesh, nullptr, 1));
    store.modes(small_modes(), mesh);
    store.stop("failed");
  }
  EXPECT_TRUE(names_in(folder.path()).empty());
}

TEST(DirectoryStore, NeverWritesANumberThatIsNotFinite) {
  const TestFolder folder;
  const mesh::Q8Mesh mesh = small_mesh();
  DirectoryStore store(folder.path() / "out");
  store.begin(small_case(), mesh, estimate(small_case(), mesh, nullptr, 1));
  store.modes(small_modes(), mesh);
  store.frequency(small_result(0.4));
  FrequencyResult bad = small_result(0.5);
  bad.wave_elevation(0, 1) = std::numeric_limits<double>::quiet_NaN();
  try {
    store.frequency(bad);
    FAIL() << "accepted";
  } catch (const ConvergenceError& error) {
    EXPECT_STREQ(error.what(),
                 "invalid wave_elevation in records/frequency_00002.rec (must be finite)");
  }
  store.stop("failed");
  for (const char* name : {"rao_points.csv", "wave_points.csv", "exciting_force.csv"})
    for (const auto& row : rows_of(folder.read(std::string("out/") + name)))
      EXPECT_NE(row[0], "0.5") << name << " keeps finished frequencies only";
}

TEST(DirectoryStore, TellsOfMixedProcessors) {
  const TestFolder folder;
  const mesh::Q8Mesh mesh = small_mesh();
  DirectoryStore store(folder.path() / "out");
  store.begin(small_case(), mesh, estimate(small_case(), mesh, nullptr, 1));
  store.modes(small_modes(), mesh);
  for (const auto& [omega, kind] : {std::pair{0.4, "Zen"}, std::pair{0.5, "Haswell"}}) {
    FrequencyResult result = small_result(omega);
    result.report.processor = kind;
    store.frequency(result);
  }
  store.finish({});
  const auto run = nlohmann::json::parse(folder.read("out/run.json"));
  EXPECT_EQ(run.at("plan").at("processors"), nlohmann::json({"Haswell", "Zen"}));
  EXPECT_THAT(run.at("warnings").back().get<std::string>(),
              HasSubstr("frequencies were solved by Haswell and by Zen (results agree"));
}

TEST(DirectoryStore, RefusesADirectoryWithResults) {
  const TestFolder folder;
  store_all(folder.path() / "out");
  const std::string before = folder.read("out/run.json");
  try {
    DirectoryStore again(folder.path() / "out");
    FAIL() << "accepted";
  } catch (const StoreError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--fresh"));
  }
  EXPECT_EQ(folder.read("out/run.json"), before);
}

TEST(DirectoryStore, ReplacesItsOwnFilesOnly) {
  const TestFolder folder;
  store_all(folder.path() / "out");
  folder.write("out/notes.txt", "mine");
  folder.write("out/fields/picture.png", "mine");
  folder.write("out/rao_points.csv.tmp.4711", "left by a killed run");
  folder.write("out/rao_points.csv.tmp.backup", "mine");
  const mesh::Q8Mesh mesh = small_mesh();
  {
    DirectoryStore store(folder.path() / "out", Existing::kReplace);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/rao_points.csv"))
        << "nothing is deleted before the new run begins";
    store.begin(small_case(), mesh, estimate(small_case(), mesh, nullptr, 1));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/rao_points.csv"));
    store.stop("failed");
  }
  EXPECT_THAT(names_in(folder.path() / "out"),
              ElementsAre("fields", "notes.txt", "rao_points.csv.tmp.backup"));
  EXPECT_THAT(names_in(folder.path() / "out/fields"), ElementsAre("picture.png"));
}

TEST(DirectoryStore, DeletesNothingOutsideWhateverTheAccountLists) {
  const TestFolder folder;
  std::filesystem::create_directory(folder.path() / "out");
  folder.write("precious", "mine");
  folder.write("out/run.json", "{\"program\":\"floe\",\"files\":[\"../precious\",\"" +
                                   (folder.path() / "precious").string() + "\",\"run.json\"]}");
  store_all(folder.path() / "out", Existing::kReplace);
  EXPECT_EQ(folder.read("precious"), "mine");
}

TEST(DirectoryStore, LeavesForeignFilesOfItsNamesAlone) {
  const TestFolder folder;
  std::filesystem::create_directory(folder.path() / "out");
  folder.write("out/rao_points.csv", "mine");
  EXPECT_THROW(DirectoryStore(folder.path() / "out"), StoreError);
  EXPECT_THROW(DirectoryStore(folder.path() / "out", Existing::kReplace), StoreError);
  std::filesystem::remove(folder.path() / "out/rao_points.csv");
  folder.write("out/run.json", "not of floe");
  EXPECT_THROW(DirectoryStore(folder.path() / "out", Existing::kReplace), StoreError);
  EXPECT_THAT(names_in(folder.path() / "out"), ElementsAre("run.json"));
}

TEST(DirectoryStore, HoldsOffASecondRun) {
  const TestFolder folder;
  {
    const DirectoryStore first(folder.path() / "out");
    EXPECT_THROW(DirectoryStore(folder.path() / "out"), BusyError);
    EXPECT_THROW(DirectoryStore(folder.path() / "out", Existing::kReplace), BusyError);
  }
  EXPECT_NO_THROW(DirectoryStore(folder.path() / "out"));
}

TEST(DirectoryStore, RefusesPathsItCannotWriteTo) {
  const TestFolder folder;
  folder.write("file", "");
  EXPECT_THROW(DirectoryStore(folder.path() / "file"), FileError);
  EXPECT_THROW(DirectoryStore(folder.path() / "file/out"), FileError);
  EXPECT_THROW(DirectoryStore(folder.path() / "no parent/out"), FileError);
  EXPECT_THROW(DirectoryStore("/proc/floe.out"), FileError);
  try {
    DirectoryStore store(folder.path() / "file");
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr((folder.path() / "file").string() + ": Not a directory"));
  }
}

TEST(DirectoryStore, ReplacesASymbolicLinkAndNotItsTarget) {
  const TestFolder folder;
  folder.write("target", "mine");
  const mesh::Q8Mesh mesh = small_mesh();
  DirectoryStore store(folder.path() / "out");
  store.begin(small_case(), mesh, estimate(small_case(), mesh, nullptr, 1));
  store.modes(small_modes(), mesh);
  for (const double omega : small_case().omega) store.frequency(small_result(omega));
  std::filesystem::create_symlink(folder.path() / "target", folder.path() / "out/rao_points.csv");
  store.finish({});
  EXPECT_EQ(folder.read("target"), "mine");
  EXPECT_FALSE(std::filesystem::is_symlink(folder.path() / "out/rao_points.csv"));
}

// Files of this process cannot grow beyond a limit while it lives
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    previous_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limited{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limited);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, previous_);
  }

 private:
  void (*previous_)(int);
  rlimit before_{};
};

TEST(DirectoryStore, KeepsFinishedFrequenciesWhenADiskFills) {
  const TestFolder folder;
  const mesh::Q8Mesh mesh = small_mesh();
  DirectoryStore store(folder.path() / "out");
  store.begin(small_case(), mesh, estimate(small_case(), mesh, nullptr, 1));
  store.modes(small_modes(), mesh);
  store.frequency(small_result(0.4));
  const auto length = std::filesystem::file_size(folder.path() / "out/run.json");
  {
    const FileSizeLimit limit(length / 2);
    try {
      store.frequency(small_result(0.5));
      FAIL() << "accepted";
    } catch (const FileError& error) {
      EXPECT_THAT(error.what(), StartsWith("cannot write " + (folder.path() / "out").string()));
      EXPECT_THAT(error.what(), HasSubstr(": File too large"));
    }
  }
  store.stop("failed");
  EXPECT_EQ(rows_of(folder.read("out/rao_points.csv")).size(), 1u + 4);
}

}  // namespace
}  // namespace floe::io
