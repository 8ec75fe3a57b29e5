#include "program/parse_errors.hpp"

#include <floe/io/case_file.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace floe::program {
namespace {

// The command that was being read, and its name as typed: "floe mesh rectangle"
const CLI::App& innermost(const CLI::App& app, std::string& name) {
  const CLI::App* command = &app;
  name = app.get_name();
  for (auto parsed = command->get_subcommands(); !parsed.empty();
       parsed = command->get_subcommands()) {
    command = parsed.back();
    name += " " + command->get_name();
  }
  return *command;
}

std::vector<std::string> names_of_commands(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* sub : command.get_subcommands({})) names.push_back(sub->get_name());
  return names;
}

std::vector<std::string> names_of_flags(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    if (!option->get_positional()) names.push_back(option->get_name());
  return names;
}

std::string hint_for(const std::string& word, const std::vector<std::string>& known,
                     const std::string& help) {
  const std::string nearest = io::nearest_name(word, known);
  return nearest.empty() ? fmt::format("known are {}; {} tells more", fmt::join(known, ", "), help)
                         : fmt::format("did you mean {}?", nearest);
}

// The first flag among the words that nobody took, or else the first word; what follows a lone --
// is no flag
std::string explain_extra_words(const std::vector<std::string>& words, const CLI::App& command,
                                const std::string& help) {
  const auto dashes = std::find(words.begin(), words.end(), "--");
  const auto flag = std::find_if(words.begin(), dashes,
                                 [](const std::string& word) { return word.starts_with("-"); });
  if (flag != dashes) {
    const std::string name = flag->substr(0, flag->find('='));
    const std::vector<std::string> flags = names_of_flags(command);
    if (std::find(flags.begin(), flags.end(), name) != flags.end())
      return fmt::format("{} before the command (belongs behind it; {} tells more)", name, help);
    return fmt::format("unknown flag {} ({})", name, hint_for(name, flags, help));
  }
  const std::string& word = dashes == words.begin() && words.size() > 1 ? words[1] : words.front();
  const std::vector<std::string> commands = names_of_commands(command);
  if (!commands.empty())
    return fmt::format("unknown word {} ({})", word, hint_for(word, commands, help));
  return fmt::format("unexpected word {} ({} tells what is expected)", word, help);
}

// "Could not convert: --length = x"
std::string explain_conversion(const std::string& text, const CLI::App& command) {
  const std::string given = text.substr(std::min(text.size(), text.find("--")));
  const std::string name = given.substr(0, given.find(' '));
  const CLI::Option* option = command.get_option_no_throw(name);
  const bool whole = option && option->get_type_name() == "INT";
  return fmt::format("invalid {} (must be a {})", given, whole ? "whole number" : "number");
}

}  // namespace

std::string explain(const CLI::ParseError& error, const CLI::App& app) {
  const std::string text = error.what();
  std::string name;
  const CLI::App& command = innermost(app, name);
  const std::string help = name + " --help";

  // Our own checks speak for themselves; the parser puts the option's name before them
  if (const auto ours = text.find("invalid -"); ours != std::string::npos) return text.substr(ours);

  // Words that nobody took count first: a misspelt flag often makes another one seem missing
  const std::vector<std::string> extra = app.remaining(true);
  if (!extra.empty()) return explain_extra_words(extra, command, help);
  if (text.find("subcommand") != std::string::npos)
    return fmt::format("missing word after {} (must be one of {}; {} tells more)", name,
                       fmt::join(names_of_commands(command), ", "), help);
  if (dynamic_cast<const CLI::ConversionError*>(&error)) return explain_conversion(text, command);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
    const std::string option = text.substr(0, text.find(':'));
    const bool too_few = text.find("missing") != std::string::npos ||
                         text.find("partially") != std::string::npos ||
                         text.find("At least") != std::string::npos;
    return too_few ? fmt::format("missing value of {} ({} tells more)", option, help)
                   : fmt::format("{} given more than once ({} tells more)", option, help);
  }
  return fmt::format("{} ({} tells more)", text, help);
}

}  // namespace floe::program
