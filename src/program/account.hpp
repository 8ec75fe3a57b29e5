#pragma once

#include "program/active_clock.hpp"
#include "program/terminal.hpp"

#include <floe/analysis.hpp>

#include <mutex>
#include <string>
#include <vector>

namespace floe::program {

enum class ProgressStyle { kAuto, kPlain, kJson, kNone };

/// The terminal account of a run: facts, a line a frequency, grouped warnings, and a progress bar
/// on a terminal; in a pipe a line of progress for every tenth of a longer run. `json`: one object
/// a line instead, for programs. `none`: warnings only. Every call is a place where a run can stop
/// cleanly after a signal.
class Account final : public Log {
 public:
  explicit Account(ProgressStyle style);

  void info(const std::string& text) override;
  void notice(const std::string& text) override;
  void warning(const std::string& text) override;
  void progress(double share, const std::string& now) override;
  /// Drops a solution that takes longer than a few seconds after a stop was asked for.
  void pause() override;

  /// "mesh       1621 nodes, 500 elements"
  void fact(const std::string& name, const std::string& text);
  /// An empty line.
  void gap() { line(""); }
  void frequency(const FrequencyResult& result);
  void sea(const SeaResult& result);  ///< a line: what the waves are and where most moves
  /// Prints the warnings that came in since the last call.
  void show_warnings();
  const Screen& screen() const { return screen_; }

 private:
  void line(const std::string& text);
  void line_of_progress(double left);
  void redraw();

  ProgressStyle style_;
  Screen screen_;
  std::mutex mutex_;  // of all below, and of standard output: the clock redraws the bar
  ProgressBar bar_;
  std::vector<std::string> pending_warnings_;
  bool table_open_ = false;
  TimeLeft time_left_;
  double share_ = 0.0, told_share_ = 0.0, told_at_ = 0.0;
  std::string now_;
  ActiveClock clock_;  // last, so that it ends first
};

/// {"event":"error","code":3,"text":"…"}, a line of the account as `json`.
void print_error_event(int code, const std::string& text);

}  // namespace floe::program
