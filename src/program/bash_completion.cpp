#include "program/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace floe::program {
namespace {

constexpr const char* kHead = R"(# bash completion of floe, printed by `floe completion bash`
_floe_files() {  # folders, and files that end in $1
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$current"; compgen -f -X "!*$1" -- "$current")
}
_floe_words() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current")
}
_floe() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local command=floe i
  COMPREPLY=()
  if [[ $current == "=" ]]; then  # --flag=
    current=
  elif [[ $previous == "=" && $COMP_CWORD -ge 2 ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$command ${COMP_WORDS[i]}" in
)";

// What completes a value or an argument; nothing for numbers
std::string action(const Flag& flag) {
  switch (kind_of(flag)) {
    case ValueKind::kChoice:
      return fmt::format("_floe_words \"{}\"", fmt::join(choices_of(flag), " "));
    case ValueKind::kFolder:
      return "compopt -o filenames 2>/dev/null; "
             "mapfile -t COMPREPLY < <(compgen -d -- \"$current\")";
    case ValueKind::kFile:
      return fmt::format("_floe_files {}", file_ending(flag));
    default:
      return ":";
  }
}

std::string in_quotes(const std::string& text) { return "\"" + text + "\""; }

}  // namespace

std::string bash_completion(const Command& top) {
  const std::vector<const Command*> all = all_commands(top);
  std::string script = kHead;

  // Find the command
  std::vector<std::string> paths;
  for (const Command* command : all)
    if (command != &top) paths.push_back(in_quotes(command->path));
  script += fmt::format("      {}) command+=\" ${{COMP_WORDS[i]}}\" ;;\n    esac\n  done\n",
                        fmt::join(paths, " | "));

  // Complete the value of a flag
  script += "  case \"$command $previous\" in\n";
  for (const Command* command : all)
    for (const Flag& flag : command->flags) {
      if (flag.value.empty()) continue;
      std::vector<std::string> patterns;
      for (const std::string& name : flag.names)
        patterns.push_back(in_quotes(command->path + " " + name));
      script += fmt::format("    {}) {}; return ;;\n", fmt::join(patterns, " | "), action(flag));
    }
  script += "  esac\n";

  // Complete flags, words and arguments
  script += "  case \"$command\" in\n";
  for (const Command* command : all) {
    std::vector<std::string> flags, words;
    for (const Flag& flag : command->flags)
      flags.insert(flags.end(), flag.names.begin(), flag.names.end());
    for (const Command& word : command->words) words.push_back(word.name());
    const std::string other = !words.empty()
                                  ? fmt::format("_floe_words \"{}\"", fmt::join(words, " "))
                              : command->arguments.empty() ? ":"
                                                           : action(command->arguments.front());
    script += fmt::format(
        "    {})\n      if [[ $current == -* ]]; then _floe_words \"{}\"; else {}; fi ;;\n",
        in_quotes(command->path), fmt::join(flags, " "), other);
  }
  return script + "  esac\n}\ncomplete -F _floe floe\n";
}

}  // namespace floe::program
