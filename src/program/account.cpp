#include "program/account.hpp"

#include "program/signals.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace floe::program {
namespace {

using Json = nlohmann::ordered_json;

void print_json(const Json& event) {
  print(event.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

constexpr const char* kTableHead =
    "\n   omega  wavelength   method  residual  reciprocity    energy    time\n"
    "   rad/s           m                           error     error";

}  // namespace

Account::Account(ProgressStyle style)
    : style_(style),
      screen_(style == ProgressStyle::kAuto ? look_at_screen() : Screen{}),
      bar_(screen_),
      clock_([this] { redraw(); }) {}

void Account::line(const std::string& text) {
  if (style_ == ProgressStyle::kNone || style_ == ProgressStyle::kJson) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  bar_.erase();
  print(text + "\n");
}

void Account::info(const std::string& text) {
  if (style_ == ProgressStyle::kJson) print_json({{"event", "info"}, {"text", text}});
  line(text);
  stop_if_asked();
}

void Account::notice(const std::string& text) {
  if (style_ == ProgressStyle::kJson) print_json({{"event", "notice"}, {"text", text}});
  line(styled(screen_, Style::kDim, "note       " + text));
  stop_if_asked();
}

void Account::warning(const std::string& text) {
  if (style_ == ProgressStyle::kJson)
    print_json({{"event", "warning"}, {"text", text}});
  else
    pending_warnings_.push_back(text);
  stop_if_asked();
}

void Account::progress(double share, const std::string& now) {
  const double seconds = clock_.seconds();
  double left = -1.0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    time_left_.note(share, seconds);
    share_ = share;
    now_ = now;
    left = time_left_.at(seconds);
    bar_.show(share, left, now);
  }
  if (style_ == ProgressStyle::kJson)
    print_json({{"event", "progress"},
                {"share", share},
                {"now", now},
                {"seconds", seconds},
                {"seconds_left", left < 0.0 ? Json(nullptr) : Json(left)}});
  line_of_progress(left);
  stop_if_asked();
}

void Account::pause() {
  constexpr double kPatience = 10.0;  // [s]
  stop_if_asked(kPatience);
}

// For people who read a log: seldom, and never in a short run
void Account::line_of_progress(double left) {
  constexpr double kShares = 0.1, kSeconds = 10.0;
  const double seconds = clock_.seconds();
  if (screen_.terminal || share_ < told_share_ + kShares || seconds < told_at_ + kSeconds) return;
  told_share_ = share_;
  told_at_ = seconds;
  line(fmt::format("progress   {:.0f} %{}", 100.0 * share_,
                   left < 0.0 ? "" : ", about " + format_duration(left) + " left"));
}

void Account::redraw() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!now_.empty()) bar_.show(share_, time_left_.at(clock_.seconds()), now_);
}

void Account::fact(const std::string& name, const std::string& text) {
  if (style_ == ProgressStyle::kJson)
    print_json({{"event", "fact"}, {"name", name}, {"text", text}});
  line(styled(screen_, Style::kBold, fmt::format("{:<10}", name)) + " " + text);
}

void Account::frequency(const FrequencyResult& result) {
  const FrequencyReport& report = result.report;
  const double wavelength = 2.0 * std::numbers::pi / result.wavenumber;
  const bool solved = report.failure.empty();
  if (style_ == ProgressStyle::kJson && !solved)
    print_json({{"event", "failure"}, {"omega", report.omega}, {"text", report.failure}});
  if (style_ == ProgressStyle::kJson && solved)
    print_json({{"event", "frequency"},
                {"omega", report.omega},
                {"wavelength", wavelength},
                {"method", report.method},
                {"iterations", report.iterations},
                {"true_residual", report.true_residual},
                {"reciprocity_error", report.reciprocity_error},
                {"energy_error", report.energy_error},
                {"seconds", report.seconds}});
  if (!table_open_) line(kTableHead);
  table_open_ = true;
  if (!solved) {
    line(fmt::format("{:8.4g}  {:10.4g}   no result", report.omega, wavelength));
    return;
  }
  line(fmt::format("{:8.4g}  {:10.4g}  {:>7}  {:8.1e}  {:11.1e}  {:8.1e}  {:>6}", report.omega,
                   wavelength, report.method, report.true_residual, report.reciprocity_error,
                   report.energy_error, format_duration(report.seconds)));
}

void Account::sea(const SeaResult& result) {
  const double largest = std::sqrt(result.node_moments.col(0).maxCoeff());
  if (style_ == ProgressStyle::kJson)
    print_json({{"event", "sea"},
                {"sea", result.sea},
                {"mean_heading_deg", result.mean_heading_deg},
                {"significant_height", result.significant_height},
                {"share_outside", result.share_outside},
                {"largest_std_deflection", largest}});
  line(
      fmt::format("{} sea {}, mean heading {:.4g}°: 4√m0 = {:.4g} m, largest standard "
                  "deviation of the deflection {:.4g} m",
                  table_open_ ? "\n" : "", result.sea, result.mean_heading_deg,
                  result.significant_height, largest));
  table_open_ = false;
}

void Account::show_warnings() {
  if (pending_warnings_.empty()) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  bar_.erase();
  std::string text;
  for (const std::string& warning : pending_warnings_)
    text += styled(screen_, Style::kYellow, "warning") + "    " + warning + "\n";
  // With no account there is nothing on standard output to belong to
  if (style_ == ProgressStyle::kNone)
    print_error(text);
  else
    print(text);
  pending_warnings_.clear();
}

void print_error_event(int code, const std::string& text) {
  print_json({{"event", "error"}, {"code", code}, {"text", text}});
}

}  // namespace floe::program
