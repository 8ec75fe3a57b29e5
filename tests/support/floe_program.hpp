#pragma once

#include "test_case.hpp"
#include "test_paths.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <string>

namespace floe::test {

/// What a run of the real program gave back.
struct ProgramResult {
  int code = -1;
  std::string output;
  std::string error;
};

/// Runs `floe ARGUMENTS` by the shell in the folder; `before` is put before it (variables, limits).
inline ProgramResult run_floe(const TestFolder& folder, const std::string& arguments,
                              const std::string& before = "") {
  const TestFolder captured;
  const std::string command = "cd '" + folder.path().string() + "' && { " + before + " '" +
                              FLOE_PROGRAM + "' " + arguments + "; } >'" +
                              (captured.path() / "output").string() + "' 2>'" +
                              (captured.path() / "error").string() + "' </dev/null";
  const int status = std::system(command.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, captured.read("output"), captured.read("error")};
}

}  // namespace floe::test
