#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace floe::program {

/// Adds up time between looks at a monotonic clock; a gap of 2 s or more means that the process was
/// stopped, and does not count.
class RunningTime final {
 public:
  using Clock = std::chrono::steady_clock;
  explicit RunningTime(Clock::time_point begin) : looked_at_(begin) {}
  void look(Clock::time_point now);
  double at(Clock::time_point now) const;  ///< [s]

 private:
  Clock::time_point looked_at_;
  double seconds_ = 0.0;
};

/// Time for which the process ran: what it was stopped by SIGSTOP or a batch system does not count,
/// nor do jumps of the wall clock.
class ActiveClock final {
 public:
  /// `tick` is called once a second, from a thread of the clock.
  explicit ActiveClock(std::function<void()> tick);
  ~ActiveClock();
  ActiveClock(const ActiveClock&) = delete;
  ActiveClock& operator=(const ActiveClock&) = delete;

  double seconds() const;  ///< since it was made

 private:
  using Clock = std::chrono::steady_clock;
  void run();

  std::function<void()> tick_;
  mutable std::mutex mutex_;
  std::condition_variable ended_;
  bool ending_ = false;
  RunningTime time_{Clock::now()};
  std::thread thread_;
};

/// Time left, from the shares of the work that were done at times. What came long ago counts less:
/// the pace is that of the latest half.
class TimeLeft final {
 public:
  /// `share` of all work is done at `seconds`; both do not fall.
  void note(double share, double seconds);
  /// At that time [s]; negative where nothing can be told yet.
  double at(double seconds) const;

 private:
  struct Sample {
    double share, seconds;
  };
  std::vector<Sample> samples_;
};

}  // namespace floe::program
