#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

/// Checks of flags whose messages have the program's shape: invalid --threads = 0 (must be …).
namespace floe::program {

CLI::Validator one_of(const std::string& option, const std::string& required,
                      const std::function<bool(const std::string&)>& accepts);

/// A number from `least` to `most`, both included.
CLI::Validator between(const std::string& option, const std::string& required, double least,
                       double most);

}  // namespace floe::program
