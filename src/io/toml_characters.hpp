#pragma once

#include "io/toml_section.hpp"

#include <string>

namespace floe::io {

/// Refuses what no TOML file may hold and what the parser does not survive, for it takes it for
/// impossible: control characters anywhere; letters beyond ASCII outside texts in quotes and
/// comments, or behind a backslash; quotes within a word; brackets that close what is not open;
/// headers of sections whose name begins with anything else than a name can. Throws InputError with
/// the place.
void require_toml_characters(const std::string& content, const CaseSource& source);

}  // namespace floe::io
