#include "program/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace floe::program {
namespace {

std::string in_quotes(const std::string& text) {
  std::string quotes = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quotes += '\\';
    quotes += c;
  }
  return quotes + "'";
}

// When the words typed so far are those of the command, and none of those below it
std::string condition(const Command& command) {
  std::string text = "__floe_at" + command.path.substr(command.path.find(' ') == std::string::npos
                                                           ? command.path.size()
                                                           : command.path.find(' '));
  return in_quotes(text);
}

std::string action(const Flag& flag) {
  switch (kind_of(flag)) {
    case ValueKind::kChoice:
      return fmt::format(" -x -a {}",
                         in_quotes(fmt::format("{}", fmt::join(choices_of(flag), " "))));
    case ValueKind::kFolder:
      return " -x -a '(__fish_complete_directories (commandline -ct))'";
    case ValueKind::kFile:
      return fmt::format(" -x -a '(__fish_complete_suffix {})'", file_ending(flag));
    case ValueKind::kOther:
      return " -x";
    default:
      return "";
  }
}

std::string flag_line(const Command& command, const Flag& flag) {
  std::string names;
  for (const std::string& name : flag.names)
    names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return fmt::format("complete -c floe -n {}{}{} -d {}\n", condition(command), names, action(flag),
                     in_quotes(flag.about));
}

}  // namespace

std::string fish_completion(const Command& top) {
  std::string script =
      "# fish completion of floe, printed by `floe completion fish`\n"
      "function __floe_at  # whether the words so far are those given, then flags and values\n"
      "    set -l words (commandline -opc)\n"
      "    set -e words[1]\n"
      "    set -l path\n"
      "    for word in $words\n"
      "        switch (string join ' ' -- $path $word)\n";
  for (const Command* command : all_commands(top))
    if (command != &top)
      script += fmt::format("            case {}\n                set -a path $word\n",
                            in_quotes(command->path.substr(command->path.find(' ') + 1)));
  script +=
      "        end\n    end\n    test \"$path\" = \"$argv\"\nend\n"
      "complete -c floe -f\n";
  for (const Command* command : all_commands(top)) {
    for (const Command& word : command->words)
      script += fmt::format("complete -c floe -n {} -a {} -d {}\n", condition(*command),
                            word.name(), in_quotes(word.about));
    for (const Flag& argument : command->arguments)
      script += fmt::format("complete -c floe -n {}{}\n", condition(*command), action(argument));
    for (const Flag& flag : command->flags) script += flag_line(*command, flag);
  }
  return script;
}

}  // namespace floe::program
