#include "program/parse_values.hpp"

#include "program/exit_code.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <map>

namespace floe::program {

double parse_bytes(const std::string& text) {
  const std::map<char, double> factors = {{'K', 1024.0},
                                          {'M', std::pow(1024.0, 2)},
                                          {'G', std::pow(1024.0, 3)},
                                          {'T', std::pow(1024.0, 4)}};
  std::string digits = text;
  double factor = 1.0;
  if (!digits.empty() && factors.contains(static_cast<char>(std::toupper(digits.back())))) {
    factor = factors.at(static_cast<char>(std::toupper(digits.back())));
    digits.pop_back();
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value) ||
      value <= 0.0)
    throw UsageError(fmt::format(
        "invalid --memory = {} (must be a positive number of bytes, or like 500M or 16G)", text));
  return value * factor;
}

double parse_time(const std::string& text) {
  const std::map<char, double> factors = {{'s', 1.0}, {'m', 60.0}, {'h', 3600.0}};
  std::string digits = text;
  double factor = 1.0;
  if (!digits.empty() && factors.contains(digits.back())) {
    factor = factors.at(digits.back());
    digits.pop_back();
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value) ||
      value <= 0.0)
    throw UsageError(fmt::format(
        "invalid --max-time = {} (must be a positive number of seconds, or like 90m or 12h)",
        text));
  return value * factor;
}

Shard parse_shard(const std::string& text) {
  Shard shard;
  const char* const last = text.data() + text.size();
  const auto [slash, error] = std::from_chars(text.data(), last, shard.index);
  bool good = error == std::errc() && slash != last && *slash == '/';
  if (good) {
    const auto [end, other] = std::from_chars(slash + 1, last, shard.count);
    good = other == std::errc() && end == last && shard.index >= 1 && shard.index <= shard.count;
  }
  if (!good)
    throw UsageError(
        fmt::format("invalid --shard = {} (must be I/N with 1 <= I <= N, like 3/40)", text));
  return shard;
}

}  // namespace floe::program
