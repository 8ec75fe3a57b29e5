#include "floe_program.hpp"
#include "sanitized.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

// Faults of what the program runs in: locale, BLAS, memory, threads.
namespace floe::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

const std::string kOutput = R"([modes]
count = 6
[output]
points = { P1 = [-150, -30], P5 = [0, 0] }
wave_points = { lee = [200.5, 0] }
quantities = ["deflection", "bending_moment_x", "pressure"]
)";

// All tables of a result
std::map<std::string, std::string> tables_in(const TestFolder& folder, const std::string& name) {
  std::map<std::string, std::string> tables;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / name))
    if (entry.path().extension() == ".csv")
      tables[entry.path().filename().string()] =
          folder.read(name + "/" + entry.path().filename().string());
  return tables;
}

TEST(Locale, WithADecimalCommaGivesTheSameBytes) {
  const TestFolder folder;
  const std::string made =
      "localedef -i de_DE -f UTF-8 '" + folder.path().string() + "/de_DE.UTF-8' >/dev/null 2>&1";
  ASSERT_EQ(std::system(made.c_str()), 0) << "the package locales is missing";
  folder.write("case.toml", kCaseText + kOutput);
  // The C library itself keeps 27 bytes of LOCPATH: not for the leak sanitizer
  const std::string german =
      "ASAN_OPTIONS=detect_leaks=0 LOCPATH='" + folder.path().string() + "' LC_ALL=de_DE.UTF-8";
  const std::string proof =
      german + " sh -c 'locale decimal_point' >'" + folder.path().string() + "/point' 2>/dev/null";
  ASSERT_EQ(std::system(proof.c_str()), 0);
  ASSERT_EQ(folder.read("point"), ",\n");
  ASSERT_EQ(run_floe(folder, "run case.toml -o c", "LC_ALL=C").code, 0);
  ASSERT_EQ(run_floe(folder, "run case.toml -o de", german).code, 0);
  EXPECT_EQ(tables_in(folder, "c"), tables_in(folder, "de"));
  EXPECT_EQ(run_floe(folder, "run case.toml -o bytes", "LC_ALL=C.ISO-8859-1").code, 0);
}

TEST(Blas, ThatCannotMultiplyIsNamedAtTheStart) {
  const TestFolder folder;
  folder.write("case.toml", kCaseText);
  const ProgramResult result = run_floe(folder, "run case.toml", test::preloading(FLOE_WRONG_BLAS));
  EXPECT_EQ(result.code, 1);
  EXPECT_THAT(result.error,
              HasSubstr("the BLAS library computes wrongly: error of a real product"));
  EXPECT_THAT(result.error, HasSubstr("no such core"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "case.out"));
}

// Powers of two up to where a run has no more allocations, and in even steps between: the last ones
// are those of HDF5, which calls exit()
std::vector<long> failing_counts() {
  std::vector<long> counts;
  for (long n = 1; n <= 1L << 17; n *= 2) counts.push_back(n);
  for (long n = 997; n < 60'000; n += 997) counts.push_back(n);
  return counts;
}

// The n-th allocation fails; each time the program says so, and going on afterwards gives what was
// never disturbed
TEST(Allocations, MayFailAtAnyCount) {
  if (test::kSanitized) GTEST_SKIP() << "not with the sanitizers";
  const TestFolder folder;
  folder.write("case.toml", kCaseText + kOutput);
  ASSERT_EQ(run_floe(folder, "run case.toml -o whole --threads 1").code, 0);
  int failed = 0;
  for (const long n : failing_counts()) {
    const ProgramResult result = run_floe(
        folder, "run case.toml -o part --resume --threads 1",
        test::preloading(FLOE_FAILING_ALLOCATIONS) +
            "OMP_NUM_THREADS=1 FLOE_FAIL_ALLOCATION=" + std::to_string(n) + " timeout -s KILL 60");
    // 7: the netCDF library tells no reason why it cannot write
    EXPECT_THAT(result.code, AnyOf(0, 1, 6, 7)) << n << ": " << result.error;
    if (result.code == 0) {  // the allocation could be done without
      std::filesystem::remove_all(folder.path() / "part");
      continue;
    }
    ++failed;
    EXPECT_THAT(result.error, HasSubstr("floe: error: ")) << n;
  }
  EXPECT_GT(failed, 20);
  ASSERT_EQ(run_floe(folder, "run case.toml -o part --resume").code, 0);
  EXPECT_EQ(tables_in(folder, "whole"), tables_in(folder, "part"));
}

TEST(Determinism, OfEveryMethodForAnyNumberOfThreads) {
  const TestFolder folder;
  for (const std::string method : {"dense", "lattice", "pfft", "fmm"}) {
    folder.write("case.toml", with("nx = 4, ny = 2", "nx = 20, ny = 4") + kOutput +
                                  "[solver]\nmethod = \"" + method + "\"\n");
    ASSERT_EQ(run_floe(folder, "run case.toml --fresh -o one --threads 1").code, 0) << method;
    for (const char* threads : {"2", "3", "7"}) {
      const ProgramResult result =
          run_floe(folder, std::string("run case.toml --fresh -o many --threads ") + threads);
      ASSERT_EQ(result.code, 0) << method << " " << result.error;
      EXPECT_EQ(tables_in(folder, "one"), tables_in(folder, "many")) << method << " " << threads;
    }
  }
}

}  // namespace
}  // namespace floe::test
