#include "io/scatter_csv.hpp"

#include "test_case.hpp"

#include <floe/io/case_file.hpp>
#include <floe/numeric/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace floe::io {
namespace {

using test::TestFolder;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kTable = "# a year\nHs\\Tz,4.5,6.5,8.5\n0.5,10,20,5\n1.5,0,12,3\n";

wave::ScatterDiagram read(const std::string& table) {
  const TestFolder folder;
  return read_scatter_diagram(folder.write("s.csv", table), wave::PeriodType::kZeroCrossing);
}

std::string refusal(const std::string& table) {
  try {
    read(table);
  } catch (const DataError& error) {
    const std::string text = error.what();
    return text.substr(text.find("s.csv"));
  }
  return "accepted";
}

TEST(ScatterTable, HoldsTheProbabilitiesOfItsClasses) {
  const std::string with_marks = "\xef\xbb\xbf" + kTable;
  for (const std::string& text : {kTable, with_marks}) {
    const wave::ScatterDiagram diagram = read(text);
    EXPECT_THAT(diagram.height, ElementsAre(0.5, 1.5));
    EXPECT_THAT(diagram.period, ElementsAre(4.5, 6.5, 8.5));
    EXPECT_NEAR(diagram.probability(1, 1), 12.0 / 50.0, 1e-15);
  }
  std::string windows = kTable;
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2)
    windows.replace(at, 1, "\r\n");
  EXPECT_EQ(read(windows).probability, read(kTable).probability);
}

TEST(ScatterTable, NamesTheFaultAndItsLine) {
  const std::pair<std::string, const char*> table[] = {
      {"", "s.csv:1: not a scatter diagram"},
      {"Hs,4\n", "s.csv:1: not a scatter diagram"},
      {"Hs;4;5\n1;2;3\n", "s.csv:1: not a scatter diagram (must be a row of periods"},
      {"Hs,4,5\n1,2\n", "s.csv:2: a row of 2 cells (must be 3 as in the row of periods)"},
      {"Hs,4,5\n1,2,3,4\n", "s.csv:2: a row of 4 cells (must be 3"},
      {"Hs,4,5\n1,0,0\n", "s.csv:1: the counts add up to 0 (must be positive)"},
      {"Hs,4,5\n1,2,-3\n", "s.csv:2: invalid count = \"-3\" in column 3 (must be finite and at"},
      {"Hs,4,5\n1,2,nan\n", "s.csv:2: invalid count = \"nan\" in column 3 (must be finite and at"},
      {"Hs,4,5\n1,2,many\n", "s.csv:2: invalid count = \"many\" in column 3 (must be a number"},
      {"Hs,4,5\n1,2,\n", "s.csv:2: invalid count = \"\" in column 3 (must be a number; 0 where"},
      {"Hs,4,SUM\n1,2,2\n", "s.csv:1: invalid period = \"SUM\" s in column 3 (must be a number; s"},
      {"Hs,4,5\n0-1,2,3\n", "s.csv:2: invalid height = \"0-1\" m in column 1 (must be a number"},
      {"Hs,4,5\n0,2,3\n", "s.csv:2: invalid height = 0 m in column 1 (must be positive and asc"},
      {"Hs,5,4\n1,2,3\n", "s.csv:1: invalid period = 4 s in column 3 (must be positive and asc"},
      {"Hs,4,5\n1,2,3\n1,2,3\n", "s.csv:3: invalid height = 1 m in column 1 (must be positive"},
      {"Hs\\Tp,4,5\n1,2,3\n",
       "s.csv:1: the table says \"Hs\\Tp\", the sea file period_type = \"Tz\" (must be the same)"},
      {"Hs,4,5\n1,1e400,3\n", "s.csv:2: invalid count = \"1e400\" in column 2 (must be a number"},
      {"Hs,4,5\n1,1e308,1e308\n", "s.csv:1: the counts add up to inf (must be positive)"},
  };
  for (const auto& [text, message] : table) EXPECT_THAT(refusal(text), HasSubstr(message)) << text;
}

TEST(ScatterTable, EveryFlippedByteIsReadOrRefused) {
  for (std::size_t at = 0; at < kTable.size(); ++at)
    for (const int bit : {0, 3, 5, 7}) {
      std::string flipped = kTable;
      flipped[at] = static_cast<char>(flipped[at] ^ (1 << bit));
      try {
        EXPECT_NEAR(read(flipped).probability.sum(), 1.0, 1e-14);
      } catch (const DataError&) {
      }
    }
}

const std::string kScatter = R"([[scatter]]
name = "north"
file = "s.csv"
period_type = "Tz"
spectrum = "jonswap"
spreading = "cos2"
mean_heading_deg = [0, 90]
heading_probability = [0.75, 0.25]
)";

std::string changed(const std::string& from, const std::string& to) {
  std::string text = kScatter;
  const auto at = text.find(from);
  return at == std::string::npos ? "no such text" : text.replace(at, from.size(), to);
}

std::string file_refusal(const std::string& text) {
  const TestFolder folder;
  folder.write("s.csv", kTable);
  try {
    read_sea_file(folder.write("sea.toml", text));
  } catch (const DataError& error) {
    return std::string(error.what()).substr(folder.path().string().size() + 1);
  }
  return "accepted";
}

TEST(ScatterSection, IsAWaveClimate) {
  const TestFolder folder;
  folder.write("s.csv", kTable);
  const SeaFile file = read_sea_file(folder.write("sea.toml", kScatter));
  ASSERT_EQ(file.climates.size(), 1u);
  const wave::WaveClimate& climate = file.climates[0];
  EXPECT_EQ(climate.name, "north");
  EXPECT_EQ(climate.gamma, 3.3);
  EXPECT_THAT(climate.heading_probability, ElementsAre(0.75, 0.25));
  EXPECT_THAT(climate.return_period_years, ElementsAre(1.0, 10.0, 100.0));
  EXPECT_EQ(climate.description, "2 heights × 3 Tz, jonswap γ = 3.3, spreading cos2");
  EXPECT_TRUE(file.seas.empty());
}

TEST(ScatterSection, NamesTheFaultAndItsPlace) {
  const std::pair<std::string, const char*> table[] = {
      {changed("period_type = \"Tz\"\n", ""),
       "sea.toml:1:1: missing scatter[0].period_type (required: must be one of Tz, Tp, Te)"},
      {changed("\"Tz\"", "\"Tm\""), "sea.toml:4:15: invalid scatter[0].period_type = \"Tm\""},
      {changed("\"Tz\"", "\"Tp\""), "s.csv:2: the table says \"Hs\\Tz\", the sea file period_type"},
      {changed("heading_probability = [0.75, 0.25]\n", ""),
       "missing scatter[0].heading_probability (required: one number for each mean heading)"},
      {changed("0.25]", "0.5]"),
       "heading_probability = a list of 2 with the sum 1.25 (must be one"},
      {changed("[0.75, 0.25]", "[1]"), "heading_probability = a list of 1 with the sum 1 (must be"},
      {changed("[0, 90]", "[0, 0]"),
       "scatter[0].mean_heading_deg (each heading must be given once"},
      {changed("file = \"s.csv\"\n", ""), "missing scatter[0].file (required: a table of heights"},
      {changed("s.csv", "none.csv"), "none.csv: cannot read: No such file"},
      {changed("\"jonswap\"", "\"pierson-moskowitz\"\ngamma = 2"), "unused scatter[0].gamma"},
      {changed("\"jonswap\"", "\"table\""), "invalid scatter[0].spectrum = \"table\" (must be one"},
      {changed("spreading = \"cos2\"\n", ""), "missing scatter[0].spreading"},
      {kScatter + "return_period_years = [0]\n",
       "invalid scatter[0].return_period_years[0] = 0 years (must be 0.001 to 1e6)"},
      {kScatter + "duration = 3600\n", "unknown key scatter[0].duration (known are name"},
      {kScatter + kScatter, "sea.toml:10:8: invalid scatter[1].name = \"north\" (must differ"},
  };
  for (const auto& [text, message] : table)
    EXPECT_THAT(file_refusal(text), HasSubstr(message)) << text;
}

}  // namespace
}  // namespace floe::io
