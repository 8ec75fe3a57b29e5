#include "test_paths.hpp"

#include <csv.hpp>
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace floe::test {
namespace {

class Csv : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) const {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    const std::filesystem::path path =
        std::filesystem::path(::testing::TempDir()) / (name + ".csv");
    std::ofstream(path) << text;
    return path;
  }
};

TEST_F(Csv, ReadsNumbersAndStringsBelowTheComments) {
  const CsvTable table = read_csv(write("# made by hand\nname,x\na,1.5\nb,-2e3\n# end\na,3\n"));
  EXPECT_EQ(table.row_count(), 3u);
  EXPECT_EQ(table.strings("name"), (std::vector<std::string>{"a", "b", "a"}));
  EXPECT_EQ(table.numbers("x"), (std::vector<double>{1.5, -2000.0, 3.0}));
  EXPECT_EQ(table.where("name", "a").numbers("x"), (std::vector<double>{1.5, 3.0}));
  EXPECT_EQ(table.where("x", 1.5).row_count(), 1u);
}

TEST_F(Csv, RejectsRaggedRowsMissingColumnsAndText) {
  EXPECT_THROW(read_csv(write("a,b\n1\n")), std::runtime_error);
  const CsvTable table = read_csv(write("a,b\n1,2x\n"));
  EXPECT_THROW(table.numbers("c"), std::runtime_error);
  EXPECT_THROW(table.numbers("b"), std::runtime_error);
  EXPECT_THROW(read_csv(write("a,b\n") += ".missing"), std::runtime_error);
}

// Every table of tests/data says where it comes from and under which licence.
TEST_F(Csv, EveryReferenceTableCarriesItsProvenance) {
  std::size_t tables = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FLOE_TEST_DATA)) {
    if (entry.path().extension() != ".csv") continue;
    ++tables;
    std::ifstream file(entry.path());
    std::string header;
    for (std::string line; std::getline(file, line) && line.rfind("#", 0) == 0;) header += line;
    for (const char* word : {"Quantity:", "Digits:", "Licence:"})
      EXPECT_NE(header.find(word), std::string::npos) << word << " missing in " << entry.path();
    EXPECT_GT(read_csv(entry.path()).row_count(), 0u) << entry.path();
  }
  EXPECT_GT(tables, 0u);
}

}  // namespace
}  // namespace floe::test
