#include "program/signals.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <initializer_list>
#include <optional>

namespace floe::program {
namespace {

// NOTE: a signal handler can reach nothing but a variable of static storage
volatile std::sig_atomic_t asked_to_stop = 0;
timespec asked_at{};
std::optional<std::chrono::steady_clock::time_point> deadline;  // set once, before any work

double seconds_since_asked(const timespec& now) {
  return static_cast<double>(now.tv_sec - asked_at.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - asked_at.tv_nsec);
}

// A signal to the process and then to its group, as `timeout` sends, is one wish
extern "C" void ask_to_stop(int signal) {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  if (asked_to_stop == 0) {
    asked_at = now;
    asked_to_stop = signal;
    static constexpr char kText[] =
        "\nfloe: stopping when what runs now is finished, in ten seconds or so (once more: at "
        "once)\n";
    const int error = errno;
    if (::isatty(STDERR_FILENO) == 1 && ::write(STDERR_FILENO, kText, sizeof kText - 1) < 0) {
    }
    errno = error;
    return;
  }
  if (seconds_since_asked(now) > 0.2) ::_exit(128 + signal);
}

void open_closed_streams() {
  for (int descriptor = 0; descriptor <= 2; ++descriptor)
    if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
      if (::open("/dev/null", descriptor == 0 ? O_RDONLY : O_WRONLY) < 0) return;
}

}  // namespace

void prepare_process() {
  open_closed_streams();
  // NOTE: HDF5 would refuse file systems without locks; our files have names of their own until
  // they are complete, and the folder is locked
  ::setenv("HDF5_USE_FILE_LOCKING", "FALSE", 0);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (signal == SIGHUP && before.sa_handler == SIG_IGN) continue;
    sigaction(signal, &action, nullptr);
  }
}

void limit_time(double seconds) {
  deadline = std::chrono::steady_clock::now() +
             std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                 std::chrono::duration<double>(seconds));
}

void stop_if_asked(double patience) {
  if (asked_to_stop != 0) {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    if (seconds_since_asked(now) < patience) return;
    if (asked_to_stop == SIGUSR1) throw TimeUp{"SIGUSR1"};
    throw Interrupted{asked_to_stop};
  }
  const std::chrono::duration<double> grace(patience);
  if (deadline && std::chrono::steady_clock::now() > *deadline + grace) throw TimeUp{};
}

}  // namespace floe::program
