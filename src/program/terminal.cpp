#include "program/terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace floe::program {
namespace {

void write_all(std::FILE* stream, const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stream);
  std::fflush(stream);
}

// Characters, not bytes: continuation bytes of UTF-8 take no column
std::size_t column_count(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

std::string first_columns(const std::string& text, std::size_t columns) {
  std::size_t at = 0, taken = 0;
  for (; at < text.size(); ++at) {
    const bool starts = (static_cast<unsigned char>(text[at]) & 0xc0) != 0x80;
    if (starts && taken++ == columns) break;
  }
  return text.substr(0, at);
}

}  // namespace

void print(const std::string& text) { write_all(stdout, text); }

void print_error(const std::string& text) { write_all(stderr, text); }

Screen look_at_screen() {
  const char* term = std::getenv("TERM");
  const char* no_colour = std::getenv("NO_COLOR");
  Screen screen;
  screen.terminal = ::isatty(STDOUT_FILENO) == 1 && term && std::string_view(term) != "dumb";
  screen.colour = screen.terminal && !(no_colour && *no_colour);
  winsize size{};
  if (screen.terminal && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    screen.columns = size.ws_col;
  return screen;
}

std::string styled(const Screen& screen, Style style, const std::string& text) {
  if (!screen.colour) return text;
  const char* code = style == Style::kBold     ? "1"
                     : style == Style::kDim    ? "2"
                     : style == Style::kYellow ? "33"
                                               : "31";
  return fmt::format("\x1b[{}m{}\x1b[0m", code, text);
}

void ProgressBar::show(double share, double left, const std::string& now) {
  const auto time = Clock::now();
  if (!screen_.terminal || (visible_ && time - drawn_ < std::chrono::milliseconds(100))) return;
  print("\r" + bar_text(share, left, now, screen_.columns - 1) + "\x1b[K");
  drawn_ = time;
  visible_ = true;
}

void ProgressBar::erase() {
  if (visible_) print("\r\x1b[K");
  visible_ = false;
}

std::string bar_text(double share, double left, const std::string& now, int columns) {
  share = std::clamp(share, 0.0, 1.0);
  std::string text = fmt::format("{:3.0f} %", 100.0 * share);
  constexpr int kBar = 24, kRoomForBar = 60;
  if (columns >= kRoomForBar) {
    const int filled = static_cast<int>(std::lround(share * kBar));
    text = fmt::format("[{}{}] {}", std::string(static_cast<std::size_t>(filled), '#'),
                       std::string(static_cast<std::size_t>(kBar - filled), '.'), text);
  }
  if (left >= 0.0) text += ", " + format_duration(left) + " left";
  if (!now.empty() &&
      column_count(text) + 2 + column_count(now) <= static_cast<std::size_t>(columns))
    text += "  " + now;
  return first_columns(text, static_cast<std::size_t>(std::max(columns, 1)));
}

std::string format_duration(double seconds) {
  if (seconds < 9.95) return fmt::format("{:.2g} s", seconds);
  const auto whole = static_cast<long long>(std::lround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace floe::program
