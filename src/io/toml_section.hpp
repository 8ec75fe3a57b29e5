#pragma once

#include "io/toml_parser.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// A case file's sections: lookups that check type, unit and range, and say where a fault lies.
namespace floe::io {

/// The file that is being read, and what it gave rise to.
struct CaseSource {
  std::string name;  ///< as the user gave it
  std::vector<std::string> notices;
  std::vector<std::string> warnings;
  /// Data files that were read, by the key that names them.
  std::map<std::string, std::filesystem::path> files = {};

  /// "CASE.toml:12:9: "
  std::string place(const toml::source_region& region) const;
  /// Throws InputError with the place before the message.
  [[noreturn]] void refuse(const toml::source_region& region, const std::string& message) const;
};

/// What a number must be.
struct NumberRule {
  const char* unit;      ///< "m"; "" for a pure number
  const char* required;  ///< "must be positive"
  bool (*accepts)(double);
};

bool is_positive(double value);  ///< finite and > 0

/// A list of numbers, with the place of each.
struct NumberList {
  std::vector<double> value;
  std::vector<toml::source_region> place;
};

/// A table of the case file with its dotted name. Borrows the table and the source.
class Section {
 public:
  /// Refuses keys that are not among `known`, naming the nearest one.
  Section(const toml::table& table, std::string name, CaseSource& source,
          std::vector<std::string> known);

  const std::string& name() const { return name_; }
  CaseSource& source() const { return source_; }
  const toml::source_region& place() const { return table_.source(); }

  /// The value of a key; a null pointer where it is not given.
  const toml::node* find(const std::string& key) const;
  /// The value of a key that must be given; `required` says what.
  const toml::node& require(const std::string& key, const std::string& required) const;
  /// "water.depth"
  std::string full_name(const std::string& key) const;

  double number(const std::string& key, const NumberRule& rule) const;
  double number_or(const std::string& key, const NumberRule& rule, double fallback) const;
  int integer(const std::string& key, int least, int largest) const;
  int integer_or(const std::string& key, int least, int largest, int fallback) const;
  bool flag_or(const std::string& key, bool fallback) const;
  std::string text_or(const std::string& key, const std::string& fallback) const;
  /// A list of numbers, or `{ from = …, to = …, count = … }`: equidistant, ends included.
  NumberList numbers(const std::string& key, const NumberRule& rule) const;
  /// The table under a key that is known to be given.
  Section table(const std::string& key, std::vector<std::string> known) const;

 private:
  const toml::table& table_;  // borrowed
  std::string name_;
  CaseSource& source_;  // borrowed
};

/// One number: its type, that it is finite where it must be, not subnormal, and the rule.
double checked_number(const toml::node& node, const std::string& name, const NumberRule& rule,
                      const CaseSource& source);

/// Exactly two finite numbers `[x, y]`.
std::pair<double, double> checked_point(const toml::node& node, const std::string& name,
                                        const CaseSource& source);

/// A value as a message shows it: `-3`, `"58,5"`, `a list`.
std::string shown(const toml::node& node);
/// A text in quotes, shortened, without control characters.
std::string shown_text(std::string_view text);

/// Keys of a table in the order of the file (the parser sorts them by name).
std::vector<const toml::key*> keys_in_file_order(const toml::table& table);

}  // namespace floe::io
