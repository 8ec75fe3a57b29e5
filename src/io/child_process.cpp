#include "io/child_process.hpp"

#include <floe/numeric/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>

namespace floe::io {
namespace {

constexpr char kResult = 'r', kFault = 'f', kNoMemory = 'm';

// Both ends are closed with the object
class Pipe {
 public:
  Pipe() {
    FLOE_VALIDATE_AS(FileError, ::pipe2(ends_.data(), O_CLOEXEC) == 0,
                     "cannot make a pipe: " << std::strerror(errno));
  }
  ~Pipe() {
    close(0);
    close(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int end(int which) const { return ends_[static_cast<std::size_t>(which)]; }
  void close(int which) {
    int& end = ends_[static_cast<std::size_t>(which)];
    if (end >= 0) ::close(end);
    end = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

// A child that is killed and buried with the object
class Child {
 public:
  explicit Child(pid_t id) : id_(id) {}
  ~Child() {
    if (id_ > 0) wait(true);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  int wait(bool kill_first) {
    if (kill_first) ::kill(id_, SIGKILL);
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = -1;
    return status;
  }

 private:
  pid_t id_;
};

rlim_t address_space() {
  std::ifstream statistics("/proc/self/statm");
  rlim_t pages = 0;
  statistics >> pages;
  return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

void limit(int resource, rlim_t value) {
  const rlimit both{value, value};
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

void confine(const ChildLimits& limits, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGSEGV, SIGBUS, SIGABRT, SIGFPE})
    std::signal(number, SIG_DFL);
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.seconds)));
#if !defined(__SANITIZE_ADDRESS__)  // which reserves terabytes
  limit(RLIMIT_AS, address_space() + limits.memory);
#endif
}

bool write_all(int end, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(end, data, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    data += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

// The life of the child: it never returns into the program's own code
[[noreturn]] void live(const std::function<std::string()>& work, const ChildLimits& limits,
                       pid_t parent, int end) {
  confine(limits, parent);
  char kind = kResult;
  std::string text;
  try {
    text = work();
  } catch (const std::bad_alloc&) {
    kind = kNoMemory;
  } catch (const std::exception& error) {
    kind = kFault;
    text = error.what();
  } catch (...) {
    ::_exit(1);
  }
  const bool told = write_all(end, &kind, 1) && write_all(end, text.data(), text.size());
  ::_exit(told ? 0 : 1);
}

// What the child says until it ends; false when it says too much or takes too long
bool listen(int end, const ChildLimits& limits, std::string& said) {
  using Clock = std::chrono::steady_clock;
  const auto stop = Clock::now() + std::chrono::duration<double>(limits.seconds);
  std::array<char, 65'536> buffer;
  for (;;) {
    const std::chrono::duration<double, std::milli> left = stop - Clock::now();
    if (left.count() <= 0.0) return false;
    pollfd waiting{end, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, static_cast<int>(std::ceil(left.count())));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    const ssize_t count = ::read(end, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return true;
    said.append(buffer.data(), static_cast<std::size_t>(count));
    if (said.size() > limits.result + 1)
      throw InputError(fmt::format("gives more than {} MiB", limits.result >> 20));
  }
}

}  // namespace

std::string run_in_child(const std::function<std::string()>& work, const ChildLimits& limits) {
  Pipe pipe;
  const pid_t parent = ::getpid(), id = ::fork();
  FLOE_VALIDATE_AS(FileError, id >= 0, "cannot start a process: " << std::strerror(errno));
  if (id == 0) live(work, limits, parent, pipe.end(1));

  // Listen until it ends
  Child child(id);
  pipe.close(1);
  std::string said;
  if (!listen(pipe.end(0), limits, said))
    throw InputError(fmt::format("takes longer than {:.3g} s to read", limits.seconds));
  const int status = child.wait(false);
  if (WIFSIGNALED(status))
    throw InputError(WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL
                         ? fmt::format("takes longer than {:.3g} s to read", limits.seconds)
                         : fmt::format("makes its reader crash (signal {})", WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0 || said.empty()) throw InputError("makes its reader fail");

  // Take what it said
  const char kind = said.front();
  said.erase(0, 1);
  if (kind == kNoMemory)
    throw InputError(fmt::format("needs more than {} MiB to be read", limits.memory >> 20));
  if (kind == kFault) throw InputError(said);
  return said;
}

}  // namespace floe::io
