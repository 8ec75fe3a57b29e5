#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

/// The commands, flags and arguments of the program as data: manual page and completion scripts are
/// made from the parser itself, so they cannot differ from `--help`.
namespace floe::program {

/// A flag or an argument.
struct Flag {
  std::vector<std::string> names;  ///< "-o", "--threads"; one name without dashes: an argument
  std::string value;               ///< what follows, "N"; "a|b|c" is a choice; empty: nothing
  std::string about;
  bool required = false;
};

/// A command, with the words that may follow it.
struct Command {
  std::string path;  ///< as typed: "floe mesh rectangle"
  std::string about;
  std::string footer;
  std::vector<Flag> flags;
  std::vector<Flag> arguments;
  std::vector<Command> words;

  std::string name() const { return path.substr(path.rfind(' ') + 1); }
};

/// The program and all that is below it.
Command describe_commands(const CLI::App& app);

/// The command and everything below it, in the order of the help.
std::vector<const Command*> all_commands(const Command& top);

/// What a value is completed by.
enum class ValueKind { kNothing, kChoice, kFolder, kFile, kOther };
ValueKind kind_of(const Flag& flag);

/// "CASE.toml" gives ".toml", "FILE" any; "a|b" gives {"a", "b"}.
std::string file_ending(const Flag& flag);
std::vector<std::string> choices_of(const Flag& flag);

}  // namespace floe::program
