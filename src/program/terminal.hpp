#pragma once

#include <chrono>
#include <string>

/// Plain output to standard output and error that survives closed pipes, pipes and odd terminals.
namespace floe::program {

/// Writes; a closed or broken stream is no error.
void print(const std::string& text);
void print_error(const std::string& text);

/// What standard output is.
struct Screen {
  bool terminal = false;  ///< a terminal that can move its cursor
  bool colour = false;    ///< and shows colours, with NO_COLOR not set
  int columns = 80;
};
Screen look_at_screen();

enum class Style { kBold, kDim, kYellow, kRed };
/// The text in that style where the screen shows colours.
std::string styled(const Screen& screen, Style style, const std::string& text);

/// A bar with share done, time left and what runs now, redrawn in place. Draws nothing where the
/// screen is no terminal.
class ProgressBar {
 public:
  explicit ProgressBar(const Screen& screen) : screen_(screen) {}
  /// At most ten times a second; `left` [s], negative: not known.
  void show(double share, double left, const std::string& now);
  void erase();

 private:
  using Clock = std::chrono::steady_clock;
  Screen screen_;
  Clock::time_point drawn_ = Clock::time_point::min();
  bool visible_ = false;
};

/// The text of a bar of at most `columns` characters; `left` is the time left [s], negative: not
/// known.
std::string bar_text(double share, double left, const std::string& now, int columns);

/// "4.2 s", "3 min 5 s", "2 h 10 min".
std::string format_duration(double seconds);

}  // namespace floe::program
