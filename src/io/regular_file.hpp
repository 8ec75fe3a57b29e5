#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace floe::io {

/// Content of a regular file of at most `largest` bytes. Anything else (a directory, a FIFO, a
/// device) is refused before it is opened, so that nothing blocks.
/// Throws InputError `PATH: why`, with the system's text where it knows why.
std::string read_regular_file(const std::filesystem::path& path, std::uintmax_t largest);

}  // namespace floe::io
