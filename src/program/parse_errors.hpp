#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace floe::program {

/// What the parser found wrong with the command line, as one line of ours: the word, what is
/// required, the nearest flag or command, and which help tells more.
std::string explain(const CLI::ParseError& error, const CLI::App& app);

}  // namespace floe::program
