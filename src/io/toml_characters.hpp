#pragma once

#include "io/toml_section.hpp"

#include <string>

namespace floe::io {

/// Refuses what no TOML file may hold and what the parser does not survive: control characters
/// anywhere, and letters beyond ASCII outside texts in quotes and comments (its test for blanks has
/// undefined behaviour there). Throws InputError with the place.
void require_toml_characters(const std::string& content, const CaseSource& source);

}  // namespace floe::io
