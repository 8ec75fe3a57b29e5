#include "program/replaceable.hpp"

#include <floe/numeric/error.hpp>

#include <algorithm>
#include <fstream>

namespace floe::program {

void require_replaceable(const std::filesystem::path& file, const std::string& what,
                         const std::vector<std::string_view>& beginnings) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return;  // writing tells what is wrong
  std::ifstream there(file, std::ios::binary);
  std::string begin(16, '\0');
  there.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(there.gcount()));
  const bool known = std::any_of(beginnings.begin(), beginnings.end(),
                                 [&](std::string_view start) { return begin.starts_with(start); });
  FLOE_VALIDATE_AS(StoreError, begin.empty() || known,
                   file.string() << " is there already and is no " << what
                                 << " (give another name with -o, or remove it)");
}

}  // namespace floe::program
