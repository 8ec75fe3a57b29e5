#pragma once

#include <exception>
#include <string>

namespace floe::program {

/// What the program tells its caller; documented and stable.
enum ExitCode : int {
  kDone = 0,
  kBug = 1,
  kCommandLine = 2,
  kCase = 3,
  kMesh = 4,
  kData = 5,
  kBudget = 6,
  kFile = 7,
  kConvergence = 8,
  kStore = 9,
  kBusy = 10,
  kTimeUp = 75,
  kSignal = 128  ///< plus the signal's number
};

/// A wrong command line (exit code 2).
class UsageError : public std::exception {
 public:
  explicit UsageError(std::string text) : text_(std::move(text)) {}
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

/// The code and the line of text that an exception ends the program with.
struct Failure {
  int code = kBug;
  std::string text;
};
Failure describe(const std::exception_ptr& error);

}  // namespace floe::program
