#pragma once

#include "program/command_words.hpp"

#include <string>

namespace floe::program {

/// Completion scripts made from what the parser knows: commands, flags, choices, and files by their
/// ending.
std::string bash_completion(const Command& top);
std::string zsh_completion(const Command& top);
std::string fish_completion(const Command& top);

}  // namespace floe::program
