#include "program/command_line.hpp"
#include "program/exit_code.hpp"
#include "program/terminal.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <exception>

namespace {

// An exception that cannot reach `main`, such as memory that is missing in the midst of threads,
// still ends the program with one line and its exit code; what was stored is on the disk
[[noreturn]] void end_at_once() {
  const std::exception_ptr error = std::current_exception();
  const floe::program::Failure failure =
      error ? floe::program::describe(error)
            : floe::program::Failure{floe::program::kBug, "internal error (terminated)"};
  floe::program::print_error(fmt::format("floe: error: {}\n", failure.text));
  std::_Exit(failure.code);
}

}  // namespace

int main(int argc, char** argv) {
  std::set_terminate(end_at_once);
  return floe::program::run_command_line(argc, argv);
}
