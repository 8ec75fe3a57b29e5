#include "io/child_process.hpp"

#include "sanitized.hpp"

#include <floe/numeric/error.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace floe::io {
namespace {

using testing::HasSubstr;

std::string fault(const std::function<std::string()>& work, const ChildLimits& limits = {}) {
  try {
    run_in_child(work, limits);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(ChildProcess, GivesBackWhatItsWorkGives) {
  const std::string large(3'000'000, 'x');
  EXPECT_EQ(run_in_child([&] { return large; }), large);
  EXPECT_EQ(run_in_child([] { return std::string("\0a\0", 3); }), std::string("\0a\0", 3));
  EXPECT_EQ(run_in_child([] { return std::string(); }), "");
}

TEST(ChildProcess, PassesItsFaultOn) {
  EXPECT_EQ(fault([]() -> std::string { throw InputError("invalid x = 3"); }), "invalid x = 3");
  EXPECT_EQ(fault([]() -> std::string { throw std::runtime_error("why"); }), "why");
}

TEST(ChildProcess, MayCrashWithoutHarm) {
  EXPECT_THAT(fault([]() -> std::string { std::abort(); }), HasSubstr("crash (signal 6)"));
  EXPECT_THAT(fault([]() -> std::string {
                std::raise(SIGSEGV);
                return "";
              }),
              HasSubstr("crash (signal 11)"));
  EXPECT_THAT(fault([]() -> std::string { std::_Exit(3); }), HasSubstr("makes its reader fail"));
}

TEST(ChildProcess, IsStoppedWhenItTakesTooMuch) {
  const auto start = std::chrono::steady_clock::now();
  const ChildLimits brief{.seconds = 0.3};
  EXPECT_THAT(fault(
                  []() -> std::string {
                    std::this_thread::sleep_for(std::chrono::minutes(5));
                    return "";
                  },
                  brief),
              HasSubstr("takes longer than 0.3 s"));
  EXPECT_THAT(fault(
                  []() -> std::string {
                    volatile bool busy = true;
                    while (busy) {
                    }
                    return "";
                  },
                  brief),
              HasSubstr("takes longer than 0.3 s"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  const ChildLimits small{.result = 1000};
  EXPECT_THAT(fault([] { return std::string(5000, 'x'); }, small), HasSubstr("gives more than"));
}

TEST(ChildProcess, MayNotTakeTheMemory) {
  if (test::kSanitized) GTEST_SKIP() << "not with the sanitizers";
  const ChildLimits small{.memory = std::size_t{64} << 20};
  EXPECT_THAT(fault(
                  [] {
                    const std::string bomb(std::size_t{1} << 30, 'x');
                    return bomb.substr(0, 3);
                  },
                  small),
              HasSubstr("needs more than 64 MiB"));
}

TEST(ChildProcess, CannotWriteFilesOrToTheTerminal) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_in_child([] {
              std::fputs("noise", stderr);
              std::fflush(stderr);
              return std::string("quiet");
            }),
            "quiet");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace floe::io
