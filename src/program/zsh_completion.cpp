#include "program/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace floe::program {
namespace {

// Inside single quotes, where colons and brackets mean something to _arguments
std::string escaped(const std::string& text) {
  std::string quoted;
  for (const char c : text) {
    if (c == '\'')
      quoted += "'\\''";
    else if (c == ':' || c == '[' || c == ']' || c == '\\')
      quoted += std::string("\\") + c;
    else
      quoted += c;
  }
  return quoted;
}

std::string action(const Flag& flag) {
  switch (kind_of(flag)) {
    case ValueKind::kChoice:
      return fmt::format("({})", fmt::join(choices_of(flag), " "));
    case ValueKind::kFolder:
      return "_files -/";
    case ValueKind::kFile:
      return fmt::format("_files -g \"*{}\"", file_ending(flag));
    default:
      return " ";
  }
}

std::string function_name(const Command& command) {
  std::string name = "_" + command.path;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

std::string flag_lines(const Command& command) {
  std::string lines;
  for (const Flag& flag : command.flags)
    for (const std::string& name : flag.names)
      lines += fmt::format(
          " \\\n    '{}[{}]{}'", name, escaped(flag.about),
          flag.value.empty() ? "" : fmt::format(":{}:{}", escaped(flag.value), action(flag)));
  return lines;
}

std::string function(const Command& command) {
  std::string text = function_name(command) + "() {\n";
  if (command.words.empty()) {
    text += "  _arguments" + flag_lines(command);
    for (const Flag& argument : command.arguments)
      text += fmt::format(" \\\n    ':{}:{}'", escaped(argument.value), action(argument));
    return text + "\n}\n";
  }
  text += "  local state\n  local -a commands\n  commands=(\n";
  for (const Command& word : command.words)
    text += fmt::format("    '{}:{}'\n", word.name(), escaped(word.about));
  text += "  )\n  _arguments -C" + flag_lines(command) +
          " \\\n    '1: :->command' \\\n    '*:: :->rest'\n  case $state in\n"
          "    command) _describe command commands ;;\n    rest)\n      case $words[1] in\n";
  for (const Command& word : command.words)
    text += fmt::format("        {}) {} ;;\n", word.name(), function_name(word));
  return text + "      esac ;;\n  esac\n}\n";
}

}  // namespace

std::string zsh_completion(const Command& top) {
  std::string script =
      "#compdef floe\n# zsh completion of floe, printed by `floe completion zsh`\n";
  for (const Command* command : all_commands(top)) script += function(*command);
  return script +
         "if [[ $funcstack[1] == _floe ]]; then _floe \"$@\"; else compdef _floe floe; fi\n";
}

}  // namespace floe::program
