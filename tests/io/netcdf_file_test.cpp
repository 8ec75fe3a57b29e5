#include "io/netcdf_file.hpp"

#include "test_case.hpp"

#include <floe/numeric/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netcdf.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <functional>
#include <limits>

namespace floe::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// A small file of every kind of content
std::filesystem::path write_example(const test::TestFolder& folder) {
  const std::filesystem::path path = folder.path() / "example.nc";
  NetcdfFile file = NetcdfFile::create(path);
  file.add_attribute("", "title", "sea of Kära");
  file.add_dimension("row", 2);
  file.add_dimension("column", 3);
  const std::vector<double> values = {1.0, 0.1, -2.5e-300, 4.0, 1.0 / 3.0, 6e300};
  file.add_numbers("plain", {"row", "column"}, values);
  file.add_numbers("deflated", {"row", "column"}, values, Compression::kDeflate);
  const std::vector<double> depth = {std::numeric_limits<double>::infinity()};
  file.add_numbers("depth", {}, depth);
  file.add_attribute("depth", "units", "m");
  file.add_attribute("depth", "limit", 0.1);
  file.add_integers("count", {"row"}, std::vector<int>{7, -8});
  file.add_texts("name", {"column"}, {"Heave", "Roll", "schräg"});
  file.add_texts("body", {}, {"plate"});
  file.define_parts("parts", {"row", "column"}, 1);
  file.put_part("parts", {1, 0}, {1, 3}, std::vector<double>{4.0, 5.0, 6.0});
  file.put_part("parts", {0, 0}, {1, 3}, std::vector<double>{1.0, 2.0, 3.0});
  file.close();
  return path;
}

TEST(NetcdfFile, GivesBackWhatWasWritten) {
  const test::TestFolder folder;
  const NetcdfFile file = NetcdfFile::open(write_example(folder));
  // NOTE: files made in memory tell their variables by name, not in the order they were made
  EXPECT_THAT(file.variables(),
              ElementsAre("body", "count", "deflated", "depth", "name", "parts", "plain"));
  for (const char* name : {"plain", "deflated"}) {
    EXPECT_THAT(file.dimensions(name), ElementsAre("row", "column"));
    EXPECT_THAT(file.shape(name), ElementsAre(2u, 3u));
    EXPECT_THAT(file.numbers(name), ElementsAre(1.0, 0.1, -2.5e-300, 4.0, 1.0 / 3.0, 6e300));
  }
  EXPECT_THAT(file.numbers("plain", {1, 1}, {1, 2}), ElementsAre(1.0 / 3.0, 6e300));
  EXPECT_THAT(file.numbers("depth"), ElementsAre(std::numeric_limits<double>::infinity()));
  EXPECT_THAT(file.numbers("count"), ElementsAre(7.0, -8.0));
  EXPECT_THAT(file.numbers("parts"), ElementsAre(1.0, 2.0, 3.0, 4.0, 5.0, 6.0));
  EXPECT_TRUE(file.holds("depth"));
  EXPECT_FALSE(file.holds("height"));
}

TEST(NetcdfFile, WritesTextsAsCharactersWithTheirEncoding) {
  const test::TestFolder folder;
  const NetcdfFile file = NetcdfFile::open(write_example(folder));
  EXPECT_THAT(file.texts("name"), ElementsAre("Heave", "Roll", "schräg"));
  EXPECT_THAT(file.dimensions("name"), ElementsAre("column", "string7"));
  EXPECT_THAT(file.dimensions("body"), ElementsAre("string5"));
  EXPECT_THAT(file.texts("body"), ElementsAre("plate"));
  EXPECT_EQ(file.attribute_text("name", "_Encoding"), "utf-8");
  EXPECT_EQ(file.attribute_text("", "title"), "sea of Kära");
  EXPECT_EQ(file.attribute_text("depth", "units"), "m");
  EXPECT_EQ(file.attribute_number("depth", "limit"), 0.1);
  EXPECT_EQ(file.attribute_text("depth", "limit"), std::nullopt);
  EXPECT_EQ(file.attribute_number("depth", "height"), std::nullopt);
}

// As files of wave spectra are: classic format, packed integers, strings by the library itself
TEST(NetcdfFile, ReadsPackedNumbersOfOtherWriters) {
  const test::TestFolder folder;
  const std::filesystem::path path = folder.path() / "packed.nc";
  int id = 0, dimension = 0, variable = 0;
  ASSERT_EQ(nc_create(path.c_str(), NC_64BIT_OFFSET, &id), NC_NOERR);
  nc_def_dim(id, "time", NC_UNLIMITED, &dimension);
  nc_def_var(id, "efth", NC_SHORT, 1, &dimension, &variable);
  const double scale = 0.5, offset = 10.0;
  const short fill = -999;
  nc_put_att_double(id, variable, "scale_factor", NC_DOUBLE, 1, &scale);
  nc_put_att_double(id, variable, "add_offset", NC_DOUBLE, 1, &offset);
  nc_put_att_short(id, variable, "_FillValue", NC_SHORT, 1, &fill);
  nc_enddef(id);
  const std::size_t start = 0, count = 3;
  const short values[] = {4, -999, -2};
  nc_put_vara_short(id, variable, &start, &count, values);
  ASSERT_EQ(nc_close(id), NC_NOERR);

  const NetcdfFile file = NetcdfFile::open(path);
  EXPECT_THAT(file.numbers("efth"), ElementsAre(4.0, -999.0, -2.0));
  const std::vector<double> meant = file.unpacked_numbers("efth");
  EXPECT_EQ(meant[0], 12.0);
  EXPECT_TRUE(std::isnan(meant[1]));
  EXPECT_EQ(meant[2], 9.0);
}

TEST(NetcdfFile, ReadsStringsToo) {
  const test::TestFolder folder;
  const std::filesystem::path path = folder.path() / "strings.nc";
  int id = 0, dimension = 0, variable = 0;
  ASSERT_EQ(nc_create(path.c_str(), NC_NETCDF4, &id), NC_NOERR);
  nc_def_dim(id, "site", 2, &dimension);
  nc_def_var(id, "station", NC_STRING, 1, &dimension, &variable);
  const char* names[] = {"north", "south"};
  nc_put_var_string(id, variable, names);
  nc_put_att_string(id, variable, "units", 1, names + 1);
  ASSERT_EQ(nc_close(id), NC_NOERR);
  const NetcdfFile file = NetcdfFile::open(path);
  EXPECT_THAT(file.texts("station"), ElementsAre("north", "south"));
  EXPECT_EQ(file.attribute_text("station", "units"), "south");
}

// The message names the file and what is wrong
template <typename Error>
void expect_message(const std::function<void()>& work, const std::string& part) {
  try {
    work();
    ADD_FAILURE() << "nothing thrown for " << part;
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(part));
  }
}

TEST(NetcdfFile, RefusesToReadWhatIsNotThere) {
  const test::TestFolder folder;
  const auto path = write_example(folder);
  expect_message<DataError>([&] { NetcdfFile::open(folder.path() / "no.nc"); }, "no.nc");
  const auto text = folder.write("text.nc", "CDF? no, plain text");
  expect_message<DataError>([&] { NetcdfFile::open(text); }, "text.nc");
  const NetcdfFile file = NetcdfFile::open(path);
  expect_message<DataError>([&] { file.numbers("height"); }, "height");
  expect_message<DataError>([&] { file.numbers("name"); }, "name");
  expect_message<DataError>([&] { file.texts("depth"); }, "depth");
}

TEST(NetcdfFile, RefusesADamagedFile) {
  const test::TestFolder folder;
  std::string bytes = (write_example(folder), folder.read("example.nc"));
  const auto cut = folder.write("cut.nc", bytes.substr(0, bytes.size() / 2));
  expect_message<DataError>([&] { NetcdfFile::open(cut); }, "cut.nc");
}

TEST(NetcdfFile, TellsWhatCannotBeWritten) {
  const test::TestFolder folder;
  expect_message<FileError>([&] { NetcdfFile::create(folder.path() / "no" / "such.nc"); },
                            "such.nc");
  NetcdfFile file = NetcdfFile::create(folder.path() / "new.nc");
  file.add_dimension("row", 2);
  expect_message<FileError>([&] { file.add_dimension("row", 3); }, "row");
  expect_message<FileError>(
      [&] { file.add_numbers("values", {"column"}, std::vector<double>{1.0}); }, "column");
}

// A disk that takes no more than 64 KiB
class SmallDisk {
 public:
  SmallDisk() {
    getrlimit(RLIMIT_FSIZE, &limit_);
    const rlimit small{.rlim_cur = 64 << 10, .rlim_max = limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit limit_{};
  void (*handler_)(int) = nullptr;
};

TEST(NetcdfFile, TellsAFullDisk) {
  const test::TestFolder folder;
  const std::vector<double> values(1 << 20, 0.1);
  const SmallDisk disk;
  expect_message<FileError>(
      [&] {
        NetcdfFile file = NetcdfFile::create(folder.path() / "large.nc");
        file.add_dimension("row", values.size());
        file.add_numbers("values", {"row"}, values);
        file.close();
      },
      "large.nc");
}

}  // namespace
}  // namespace floe::io
