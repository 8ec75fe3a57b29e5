#include "program/active_clock.hpp"

#include <algorithm>
#include <csignal>
#include <system_error>

namespace floe::program {
namespace {

constexpr std::chrono::milliseconds kLook{100};
constexpr double kLongestGap = 2.0;  // [s]
constexpr int kLooksPerTick = 10;

}  // namespace

void RunningTime::look(Clock::time_point now) {
  seconds_ = at(now);
  looked_at_ = now;
}

double RunningTime::at(Clock::time_point now) const {
  const double gap = std::chrono::duration<double>(now - looked_at_).count();
  return seconds_ + (gap < kLongestGap ? gap : 0.0);
}

ActiveClock::ActiveClock(std::function<void()> tick) : tick_(std::move(tick)) {
  // Signals are for the threads that compute
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  try {
    thread_ = std::thread([this] { run(); });
  } catch (const std::system_error&) {  // no more threads: a clock that looks when it is asked
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

ActiveClock::~ActiveClock() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  ended_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void ActiveClock::run() {
  for (int looks = 1;; ++looks) {
    {
      std::unique_lock<std::mutex> lock(mutex_);
      if (ended_.wait_for(lock, kLook, [this] { return ending_; })) return;
      time_.look(Clock::now());
    }
    if (looks % kLooksPerTick == 0) tick_();
  }
}

double ActiveClock::seconds() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return time_.at(Clock::now());
}

void TimeLeft::note(double share, double seconds) {
  if (!samples_.empty() && share <= samples_.back().share) return;
  samples_.push_back({share, seconds});
}

double TimeLeft::at(double seconds) const {
  if (samples_.size() < 2) return -1.0;
  const Sample& last = samples_.back();
  // The pace since half of what is done was done, or since the sample before the last one
  auto from = std::find_if(samples_.begin(), samples_.end(),
                           [&](const Sample& sample) { return sample.share >= 0.5 * last.share; });
  if (from + 1 == samples_.end()) --from;
  const double pace = (last.seconds - from->seconds) / (last.share - from->share);
  return std::max(0.0, (1.0 - last.share) * pace - (seconds - last.seconds));
}

}  // namespace floe::program
