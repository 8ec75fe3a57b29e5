#pragma once

#include <filesystem>
#include <string>

namespace floe::mesh {

/// Content of a regular file. Throws MeshError if there is none or it is something else (a
/// directory, a pipe, a device: never waits on them), FileError if reading fails midway.
std::string read_regular_file(const std::filesystem::path& path);

/// Writes `content` beside `path` and moves it there, so that nobody sees half a file. What is no
/// regular file (a device) is written directly. Throws FileError.
void replace_file(const std::filesystem::path& path, const std::string& content);

}  // namespace floe::mesh
