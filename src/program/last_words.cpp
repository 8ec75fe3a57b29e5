#include "program/last_words.hpp"

#include "program/exit_code.hpp"
#include "program/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>

namespace floe::program {
namespace {

std::atomic<bool> at_work{true};

[[noreturn]] void end_at_once() {
  const std::exception_ptr error = std::current_exception();
  const Failure failure = error ? describe(error) : Failure{kBug, "internal error (terminated)"};
  print_error(fmt::format("floe: error: {}\n", failure.text));
  std::_Exit(failure.code);
}

// Nothing but write(2) is safe in the handler of a fault or when a library has given up
void say(const char* text) {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
}

void end_library_exit() {
  if (!at_work) return;
  say("floe: error: internal error: a library ended the program, most likely for want of memory "
      "(what was finished is kept; go on with --resume)\n");
  std::_Exit(kBug);
}

[[maybe_unused]] void end_fault(int number) {
  say("floe: error: internal error: ");
  switch (number) {
    case SIGILL:
      say("this processor lacks an instruction (SIGILL)");
      break;
    case SIGFPE:
      say("arithmetic fault (SIGFPE)");
      break;
    case SIGABRT:
      say("a library gave up (SIGABRT)");
      break;
    default:
      say("fault of memory access (SIGSEGV)");
      break;
  }
  say(", perhaps for want of memory (what was finished is kept; go on with --resume)\n");
  std::_Exit(kBug);
}

// On a stack of its own, for the fault may be that the stack is full. The sanitizers tell more
void install_fault_handler() {
#ifndef __SANITIZE_ADDRESS__
  static char stack[1 << 16];
  stack_t own{};
  own.ss_sp = stack;
  own.ss_size = sizeof stack;
  ::sigaltstack(&own, nullptr);
  struct sigaction action {};
  action.sa_handler = end_fault;
  action.sa_flags = SA_ONSTACK | SA_RESETHAND;
  for (const int number : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT})
    ::sigaction(number, &action, nullptr);
#endif
}

}  // namespace

void install_last_words() {
  std::set_terminate(end_at_once);
  std::atexit(end_library_exit);
  install_fault_handler();
}

void end_in_peace() { at_work = false; }

}  // namespace floe::program
