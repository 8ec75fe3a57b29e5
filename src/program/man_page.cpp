#include "program/man_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

namespace floe::program {
namespace {

// Text as roff shows it: dashes stay dashes, no line is taken for a request
std::string escaped(const std::string& text) {
  std::string roff;
  for (const char c : text) {
    if (c == '-' || c == '\\') roff += '\\';
    if (c == '\\') {
      roff += 'e';
      continue;
    }
    if ((c == '.' || c == '\'') && (roff.empty() || roff.back() == '\n')) roff += "\\&";
    roff += c;
  }
  return roff;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

std::string synopsis(const Command& command) {
  std::string line = bold(command.path);
  if (!command.flags.empty()) line += " [" + italic("OPTIONS") + "]";
  for (const Flag& argument : command.arguments)
    line += argument.required ? " " + italic(argument.value) : " [" + italic(argument.value) + "]";
  return line + "\n";
}

std::string paragraph(const Flag& flag) {
  std::vector<std::string> names;
  for (const std::string& name : flag.names) names.push_back(bold(name));
  std::string head = fmt::format("{}", fmt::join(names, ", "));
  if (!flag.value.empty()) head += " " + italic(flag.value);
  return fmt::format(".TP\n{}\n{}{}\n", head, escaped(flag.about),
                     flag.required ? " (required)" : "");
}

std::string section(const Command& command) {
  std::string text = ".SS " + synopsis(command) + escaped(command.about) + ".\n";
  for (const Flag& argument : command.arguments)
    text += fmt::format(".TP\n{}\n{}\n", italic(argument.value), escaped(argument.about));
  for (const Flag& flag : command.flags) text += paragraph(flag);
  if (!command.footer.empty()) text += ".PP\n.nf\n" + escaped(command.footer) + "\n.fi\n";
  return text;
}

// The footer of the whole program: a list of examples, then the exit codes
std::string examples_and_codes(const std::string& footer) {
  const std::size_t codes = footer.find("Exit codes:");
  const std::string examples = footer.substr(0, codes);
  std::string text = ".SH EXAMPLES\n.nf\n";
  std::istringstream lines(examples);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  ")) text += escaped(line.substr(2)) + "\n";
  text += ".fi\n";
  if (codes != std::string::npos)
    text += ".SH EXIT STATUS\n" + escaped(footer.substr(footer.find(':', codes) + 2)) + "\n";
  return text;
}

}  // namespace

std::string man_page(const Command& top, const std::string& version) {
  std::string text = fmt::format(".TH FLOE 1 \"\" \"floe {}\" \"User Commands\"\n", version);
  text += ".SH NAME\nfloe \\- hydroelastic response of very large floating structures in waves\n";
  text += ".SH SYNOPSIS\n";
  for (const Command* command : all_commands(top))
    if (command->words.empty()) text += synopsis(*command) + ".br\n";
  text +=
      ".SH DESCRIPTION\n"
      "floe computes how a very large floating structure bends in waves: a thin elastic plate of\n"
      "any outline on water of any constant depth, in the frequency domain, to first order.\n"
      "A case is a TOML file in SI units; results are CSV tables, fields for ParaView, a\n"
      "run.json that says how far they can be trusted, and one HTML page.\n";
  text += ".SH OPTIONS\n";
  for (const Flag& flag : top.flags) text += paragraph(flag);
  text += ".SH COMMANDS\n";
  for (const Command* command : all_commands(top))
    if (command != &top && command->words.empty()) text += section(*command);
  text += examples_and_codes(top.footer);
  return text;
}

}  // namespace floe::program
