#include "io/record_names.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace floe::io {
namespace {

constexpr std::string_view kSuffix = ".rec";
constexpr std::array<std::string_view, 6> kSingle = {"mesh",      "plate_mesh", "modes",
                                                     "sea_march", "sea_grid",   "sea_observation"};
constexpr std::array<std::string_view, 5> kNumbered = {"frequency_", "failure_", "transfer_",
                                                       "sample_", "sea_"};

bool is_number(std::string_view text) {
  return text.size() >= 5 && text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::string numbered_record(const std::string& what, std::size_t place) {
  std::string digits = std::to_string(place + 1);
  if (digits.size() < 5) digits.insert(0, 5 - digits.size(), '0');
  return kRecords + "/" + what + "_" + digits + ".rec";
}

bool is_record_name(const std::string& name) {
  std::string_view stem = name;
  if (!stem.ends_with(kSuffix)) return false;
  stem.remove_suffix(kSuffix.size());
  return std::find(kSingle.begin(), kSingle.end(), stem) != kSingle.end() ||
         std::any_of(kNumbered.begin(), kNumbered.end(), [&](std::string_view what) {
           return stem.starts_with(what) && is_number(stem.substr(what.size()));
         });
}

std::vector<std::string> records_in(const std::filesystem::path& directory) {
  std::vector<std::string> names;
  for (const std::string& folder : {kRecords, kBadRecords}) {
    std::error_code ignored;
    for (std::filesystem::directory_iterator at(directory / folder, ignored), end;
         !ignored && at != end; at.increment(ignored))
      if (is_record_name(at->path().filename().string()))
        names.push_back(folder + "/" + at->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace floe::io
