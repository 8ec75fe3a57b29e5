#include "program/option_checks.hpp"

#include <fmt/format.h>

#include <charconv>

namespace floe::program {

CLI::Validator one_of(const std::string& option, const std::string& required,
                      const std::function<bool(const std::string&)>& accepts) {
  return CLI::Validator(
      [=](std::string& text) {
        return accepts(text) ? ""
                             : fmt::format("invalid {} = {} (must be {})", option, text, required);
      },
      "");
}

CLI::Validator between(const std::string& option, const std::string& required, double least,
                       double most) {
  return one_of(option, required, [=](const std::string& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && value >= least &&
           value <= most;
  });
}

}  // namespace floe::program
