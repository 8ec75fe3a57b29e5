#include "floe_program.hpp"

#include <gtest/gtest.h>

#include <map>

// What the program runs in: locale, threads.
namespace floe::test {
namespace {

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
  const std::string german = "LOCPATH='" + folder.path().string() + "' LC_ALL=de_DE.UTF-8";
  const std::string proof =
      german + " sh -c 'locale decimal_point' >'" + folder.path().string() + "/point' 2>/dev/null";
  ASSERT_EQ(std::system(proof.c_str()), 0);
  ASSERT_EQ(folder.read("point"), ",\n");
  ASSERT_EQ(run_floe(folder, "run case.toml -o c", "LC_ALL=C").code, 0);
  ASSERT_EQ(run_floe(folder, "run case.toml -o de", german).code, 0);
  EXPECT_EQ(tables_in(folder, "c"), tables_in(folder, "de"));
  EXPECT_EQ(run_floe(folder, "run case.toml -o bytes", "LC_ALL=C.ISO-8859-1").code, 0);
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
