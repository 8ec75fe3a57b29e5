#pragma once

#include "program/command_words.hpp"

#include <string>

namespace floe::program {

/// The manual page floe(1) in roff, made from what the parser knows.
std::string man_page(const Command& top, const std::string& version);

}  // namespace floe::program
