#include "io/record.hpp"

#include "record_version.hpp"
#include "test_case.hpp"

#include <floe/numeric/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace floe::io {
namespace {

using test::TestFolder;
using testing::HasSubstr;

Record small_record() {
  Record record;
  record.put("matrix", MatXd{{1.0, 2.0}, {3.0, -4.5}});
  record.put("waves", MatXcd{{Complex(1.0, -1.0), Complex(0.0, 2.0)}});
  record.put("omega", 0.1 + 0.2);
  record.put("method", std::string("dense\nµ"));
  record.put("nothing", MatXd(0, 3));
  return record;
}

std::string complaint(const std::filesystem::path& path) {
  try {
    Record::read(path);
  } catch (const StoreError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Record, ReadsBackWhatWasWritten) {
  const TestFolder folder;
  small_record().write(folder.path() / "a.rec");
  const Record record = Record::read(folder.path() / "a.rec");
  EXPECT_EQ(record.real("matrix"), small_record().real("matrix"));
  EXPECT_EQ(record.complex("waves"), small_record().complex("waves"));
  EXPECT_EQ(record.number("omega"), 0.1 + 0.2);
  EXPECT_EQ(record.text("method"), "dense\nµ");
  EXPECT_EQ(record.real("nothing").cols(), 3);
  EXPECT_THROW(record.real("waves"), StoreError);
  EXPECT_THROW(record.number("matrix"), StoreError);
  EXPECT_THROW(record.text("absent"), StoreError);
}

TEST(Record, NoticesEveryChangedByte) {
  const TestFolder folder;
  small_record().write(folder.path() / "a.rec");
  const std::string good = folder.read("a.rec");
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x10);
    EXPECT_NE(complaint(folder.write("b.rec", bad)), "accepted") << "byte " << i;
  }
}

TEST(Record, NoticesEveryMissingEnd) {
  const TestFolder folder;
  small_record().write(folder.path() / "a.rec");
  const std::string good = folder.read("a.rec");
  for (std::size_t length = 0; length < good.size(); ++length)
    EXPECT_NE(complaint(folder.write("b.rec", good.substr(0, length))), "accepted") << length;
  EXPECT_NE(complaint(folder.write("b.rec", good + "x")), "accepted");
}

TEST(Record, SaysWhatIsWrong) {
  const TestFolder folder;
  EXPECT_THAT(complaint(folder.path() / "none.rec"), HasSubstr("none.rec: cannot read"));
  EXPECT_THAT(complaint(folder.write("b.rec", std::string(100, 'x'))),
              HasSubstr("is not one of floe"));
  small_record().write(folder.path() / "a.rec");
  const std::string newer = test::with_version(folder.read("a.rec"), 3);
  EXPECT_THAT(complaint(folder.write("b.rec", newer)),
              HasSubstr("has the format version 3, this floe reads 2"));
}

}  // namespace
}  // namespace floe::io
