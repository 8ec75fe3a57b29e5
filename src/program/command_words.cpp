#include "program/command_words.hpp"

#include <sstream>

namespace floe::program {
namespace {

Flag describe_flag(const CLI::Option& option) {
  Flag flag;
  for (const std::string& name : option.get_snames()) flag.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) flag.names.push_back("--" + name);
  if (option.get_positional()) flag.names = {option.get_name()};
  if (option.get_items_expected_max() > 0) flag.value = option.get_type_name();
  flag.about = option.get_description();
  flag.required = option.get_required();
  return flag;
}

Command describe_command(const CLI::App& app, const std::string& path) {
  Command command;
  command.path = path;
  command.about = app.get_description();
  command.footer = app.get_footer();
  for (const CLI::Option* option : app.get_options())
    (option->get_positional() ? command.arguments : command.flags)
        .push_back(describe_flag(*option));
  for (const CLI::App* word : app.get_subcommands({}))
    command.words.push_back(describe_command(*word, path + " " + word->get_name()));
  return command;
}

void collect(const Command& command, std::vector<const Command*>& all) {
  all.push_back(&command);
  for (const Command& word : command.words) collect(word, all);
}

}  // namespace

Command describe_commands(const CLI::App& app) { return describe_command(app, app.get_name()); }

std::vector<const Command*> all_commands(const Command& top) {
  std::vector<const Command*> all;
  collect(top, all);
  return all;
}

ValueKind kind_of(const Flag& flag) {
  if (flag.value.empty()) return ValueKind::kNothing;
  if (flag.value.find('|') != std::string::npos) return ValueKind::kChoice;
  if (flag.value == "DIR") return ValueKind::kFolder;
  const bool file = flag.value == "FILE" || flag.value.find('.') != std::string::npos;
  return file ? ValueKind::kFile : ValueKind::kOther;
}

std::string file_ending(const Flag& flag) {
  return flag.value == "FILE" ? "" : flag.value.substr(flag.value.rfind('.'));
}

std::vector<std::string> choices_of(const Flag& flag) {
  std::vector<std::string> choices;
  std::istringstream text(flag.value);
  for (std::string choice; std::getline(text, choice, '|');) choices.push_back(choice);
  return choices;
}

}  // namespace floe::program
