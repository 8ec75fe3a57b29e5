#include "floe_program.hpp"
#include "program/active_clock.hpp"
#include "program/terminal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

// The bar, the time that is left, and what a run tells a pipe, a terminal and a program.
namespace floe::program {
namespace {

using test::kCaseText;
using test::ProgramResult;
using test::run_floe;
using test::TestFolder;
using test::with;
using testing::HasSubstr;
using testing::Not;

TEST(TimeLeft, FollowsFromThePaceOfTheLatestHalf) {
  TimeLeft left;
  EXPECT_LT(left.at(0.0), 0.0);
  left.note(0.0, 10.0);
  EXPECT_LT(left.at(20.0), 0.0) << "nothing is done yet";
  left.note(0.25, 20.0);
  EXPECT_DOUBLE_EQ(left.at(20.0), 30.0);
  EXPECT_DOUBLE_EQ(left.at(24.0), 26.0) << "time goes by between two notes";
  // Four times slower from here on; a share that does not rise is no news
  left.note(0.5, 60.0);
  left.note(0.4, 61.0);
  EXPECT_DOUBLE_EQ(left.at(60.0), 80.0);
  EXPECT_DOUBLE_EQ(left.at(1000.0), 0.0);
}

TEST(RunningTime, LeavesOutWhatTheProcessWasStopped) {
  using Clock = RunningTime::Clock;
  const Clock::time_point begin{};
  const auto after = [&](double seconds) {
    return begin +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  };
  RunningTime time(begin);
  for (int i = 1; i <= 10; ++i) time.look(after(0.1 * i));
  EXPECT_NEAR(time.at(after(1.5)), 1.5, 1e-9);
  time.look(after(3601.0));  // SIGSTOP at 1 s, SIGCONT an hour later
  EXPECT_NEAR(time.at(after(3601.0)), 1.0, 1e-9);
  EXPECT_NEAR(time.at(after(3601.25)), 1.25, 1e-9);
}

TEST(Bar, FitsTheTerminal) {
  EXPECT_EQ(bar_text(0.5, 90.0, "frequency 3 of 5", 79),
            "[############............]  50 %, 1 min 30 s left  frequency 3 of 5");
  EXPECT_EQ(bar_text(0.5, -1.0, "frequency 3 of 5", 79),
            "[############............]  50 %  frequency 3 of 5");
  EXPECT_EQ(bar_text(0.5, 90.0, "frequency 3 of 5", 40),
            " 50 %, 1 min 30 s left  frequency 3 of 5");
  EXPECT_EQ(bar_text(0.5, 90.0, "frequency 3 of 5", 19), " 50 %, 1 min 30 s l");
  EXPECT_EQ(bar_text(0.5, 90.0, "", 4), " 50 ");
  EXPECT_EQ(bar_text(7.0, 0.0, "", 80), "[########################] 100 %, 0 s left");
}

// Inside a terminal of so many columns, as script(1) makes one
ProgramResult run_in_terminal(const TestFolder& folder, const std::string& variables, int columns) {
  const std::string command = "stty cols " + std::to_string(columns) + "; " + variables + " '" +
                              FLOE_PROGRAM + "' run case.toml --fresh";
  return run_floe(folder, "--version >version; script -qec \"" + command + "\" /dev/null");
}

TEST(Progress, DrawsABarOnATerminalOnly) {
  const TestFolder folder;
  folder.write("case.toml", kCaseText);
  if (std::system("command -v script >/dev/null") != 0) GTEST_SKIP() << "no script(1)";
  const ProgramResult bar = run_in_terminal(folder, "TERM=xterm", 80);
  EXPECT_EQ(bar.code, 0) << bar.error;
  EXPECT_THAT(bar.output, HasSubstr("\r["));
  EXPECT_THAT(bar.output, HasSubstr("\x1b[1m"));
  const ProgramResult plain = run_in_terminal(folder, "NO_COLOR=1 TERM=xterm", 80);
  EXPECT_THAT(plain.output, HasSubstr("\r["));
  EXPECT_THAT(plain.output, Not(HasSubstr("\x1b[1m")));
  const ProgramResult dumb = run_in_terminal(folder, "TERM=dumb", 80);
  EXPECT_THAT(dumb.output, Not(HasSubstr("\x1b")));
  const ProgramResult narrow = run_in_terminal(folder, "NO_COLOR=1 TERM=xterm", 20);
  EXPECT_EQ(narrow.code, 0);
  // What is drawn over itself stays on one line
  std::istringstream lines(narrow.output);
  for (std::string piece; std::getline(lines, piece, '\r');)
    if (const auto end = piece.find("\x1b[K"); end != std::string::npos) {
      EXPECT_LE(end, 19u);
    }
  const ProgramResult pipe = run_floe(folder, "run case.toml --fresh", "TERM=xterm");
  EXPECT_THAT(pipe.output, Not(HasSubstr("\r")));
}

TEST(Progress, TellsProgramsTheShareAndTheTimeLeft) {
  const TestFolder folder;
  folder.write("case.toml", with("[0.4, 0.5]", "{ from = 0.2, to = 0.6, count = 20 }"));
  const ProgramResult result = run_floe(folder, "run case.toml --progress=json");
  ASSERT_EQ(result.code, 0) << result.error;
  std::istringstream lines(result.output);
  double share = 0.0;
  int events = 0, told = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto event = nlohmann::json::parse(line);
    if (event.at("event") != "progress") continue;
    ++events;
    EXPECT_GE(event.at("share").get<double>(), share);
    share = event.at("share");
    if (!event.at("seconds_left").is_null()) ++told;
  }
  EXPECT_EQ(share, 1.0);
  EXPECT_GE(events, 21);
  EXPECT_GE(told, 18);
}

TEST(Progress, OfAResumedRunCountsOnlyWhatIsLeft) {
  const TestFolder folder;
  folder.write("case.toml", with("[0.4, 0.5]", "{ from = 0.2, to = 0.6, count = 20 }"));
  ASSERT_EQ(run_floe(folder, "run case.toml").code, 0);
  std::filesystem::remove(folder.path() / "case.out/records/frequency_00020.rec");
  const ProgramResult result = run_floe(folder, "run case.toml --resume --progress=json");
  ASSERT_EQ(result.code, 0) << result.error;
  std::istringstream lines(result.output);
  for (std::string line; std::getline(lines, line);) {
    const auto event = nlohmann::json::parse(line);
    if (event.at("event") == "progress" && event.at("now") != "done") {
      EXPECT_EQ(event.at("share"), 0.0) << line;
    }
  }
}

}  // namespace
}  // namespace floe::program
