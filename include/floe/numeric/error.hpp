#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

/// What can go wrong, one type a cause. The program turns each into its documented exit code.
/// Message grammar: what = value unit (what is required); lower case, no full stop.
namespace floe {

/// Base of every error that floe throws on purpose.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A case file or an argument is wrong (exit code 3).
class InputError : public Error {
 public:
  using Error::Error;
};

/// A mesh or geometry cannot be used (exit code 4).
class MeshError : public InputError {
 public:
  using InputError::InputError;
};

/// A sea state or another data file is wrong (exit code 5).
class DataError : public InputError {
 public:
  using InputError::InputError;
};

/// The case would exceed memory, disk or time (exit code 6).
class BudgetError : public Error {
 public:
  using Error::Error;
};

/// Reading or writing a file failed during the run (exit code 7).
class FileError : public Error {
 public:
  using Error::Error;
};

/// A solution did not converge or is not finite (exit code 8).
class ConvergenceError : public Error {
 public:
  using Error::Error;
};

/// A result directory cannot be used: it holds other results (exit code 9).
class StoreError : public Error {
 public:
  using Error::Error;
};

/// Another run holds the result directory (exit code 10).
class BusyError : public Error {
 public:
  using Error::Error;
};

}  // namespace floe

#define FLOE_DETAIL_THROW(type, message) \
  do {                                   \
    std::ostringstream floe_message;     \
    floe_message << message;             \
    throw type(floe_message.str());      \
  } while (false)

/// Checks user data, always on. Throws InputError with the streamed message.
#define FLOE_VALIDATE(condition, message)                             \
  do {                                                                \
    if (!(condition)) FLOE_DETAIL_THROW(::floe::InputError, message); \
  } while (false)

/// The same for another error type: FLOE_VALIDATE_AS(MeshError, area > 0, "…").
#define FLOE_VALIDATE_AS(type, condition, message)              \
  do {                                                          \
    if (!(condition)) FLOE_DETAIL_THROW(::floe::type, message); \
  } while (false)

/// Pre- and postconditions: on in builds with FLOE_CHECKS (dev, asan), off in release.
#ifdef FLOE_CHECKS
#define FLOE_DETAIL_CHECK(kind, condition)                                            \
  do {                                                                                \
    if (!(condition))                                                                 \
      FLOE_DETAIL_THROW(std::logic_error,                                             \
                        kind " failed: " #condition " at " __FILE__ ":" << __LINE__); \
  } while (false)
#else
#define FLOE_DETAIL_CHECK(kind, condition) \
  do {                                     \
  } while (false)
#endif
#define FLOE_EXPECT(condition) FLOE_DETAIL_CHECK("precondition", condition)
#define FLOE_ENSURE(condition) FLOE_DETAIL_CHECK("postcondition", condition)
