#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace floe::program {

/// Throws StoreError where a file of that name is there and begins with none of `beginnings`: it is
/// no earlier `what`, and would be lost.
void require_replaceable(const std::filesystem::path& file, const std::string& what,
                         const std::vector<std::string_view>& beginnings);

}  // namespace floe::program
