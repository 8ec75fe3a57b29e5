#include "io/case_sections.hpp"
#include "io/regular_file.hpp"

#include <floe/io/case_file.hpp>
#include <floe/numeric/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace floe::io {
namespace {

constexpr std::uintmax_t kLargestFile = 16u << 20;

// A key of many parts makes tables in tables, through which the parser goes by recursion. Refuses
// the line in which a key has too many; texts in quotes and comments may hold any dots
void require_shallow_keys(std::string_view content, const CaseSource& source) {
  constexpr int kMostDots = 100;
  int dots = 0;
  toml::source_region place;
  place.begin = {1, 1};
  std::string_view quotes;  // of the text that is open
  bool comment = false;
  for (std::size_t i = 0; i < content.size(); ++i) {
    const char c = content[i];
    const bool line_ends = c == '\n';
    if (line_ends) ++place.begin.line;
    if (comment) {
      comment = !line_ends;
    } else if (!quotes.empty()) {
      const bool closes = content.substr(i).starts_with(quotes);
      const bool escapes = c == '\\' && quotes.front() == '"';
      if (escapes && !content.substr(i + 1).starts_with('\n')) ++i;
      if (closes) i += quotes.size() - 1;
      // Three quotes that close may follow one or two that do not
      for (int more = 0; closes && quotes.size() == 3 && more < 2; ++more)
        if (content.substr(i + 1).starts_with(c)) ++i;
      if (closes || (line_ends && quotes.size() == 1)) quotes = {};
    } else if (c == '"' || c == '\'') {
      const bool long_text = content.substr(i).starts_with(std::string(3, c));
      quotes = content.substr(i, long_text ? 3 : 1);
      i += quotes.size() - 1;
    } else if (c == '.') {
      if (++dots > kMostDots)
        source.refuse(place, fmt::format("invalid key of more than {} parts", kMostDots));
    } else {
      comment = c == '#';
      if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots = 0;
    }
  }
}

toml::table parse(const std::string& content, const CaseSource& source) {
  require_shallow_keys(content, source);
  try {
    return toml::parse(content, source.name);
  } catch (const toml::parse_error& error) {
    std::string text(error.description());
    if (text.size() > 1 && !std::isupper(static_cast<unsigned char>(text[1])))
      text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    // The parser shows what it saw, line breaks too
    std::replace_if(
        text.begin(), text.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
    source.refuse(error.source(), "not valid TOML: " + text);
  }
}

void require_content(const std::string& content, const CaseSource& source,
                     const std::string& what) {
  FLOE_VALIDATE(content.find_first_not_of(" \t\r\n") != std::string::npos,
                source.name << ": the file is empty (must hold " << what << ")");
}

void require_sections(const Section& root) {
  for (const char* name : {"water", "plate", "mesh", "waves"})
    root.require(name, fmt::format("a section [{}] is required", name));
}

// The direct route has no modes, from which the seas are integrated; and its preconditioner and
// bounds are those of a plate by its properties
void require_route(const Section& root, const Case& data) {
  if (data.route == SolverRoute::kModal) return;
  if (data.structure)
    root.source().refuse(root.table("plate", plate_keys()).find("structure")->source(),
                         "invalid plate.structure with solver.route = \"direct\" (a structure of "
                         "another program needs solver.route = \"modal\")");
  for (const char* section : {"sea", "sea_grid"})
    if (const toml::node* found = root.find(section))
      root.source().refuse(found->source(),
                           fmt::format("invalid {} with solver.route = \"direct\" (seas need "
                                       "solver.route = \"modal\")",
                                       section));
}

// The title goes to terminals and into comments of tables: one line, no commands to a terminal
std::string read_title(const Section& root) {
  std::string title = root.text_or("title", "");
  const bool plain = std::none_of(title.begin(), title.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  if (!plain)
    root.source().refuse(root.find("title")->source(),
                         fmt::format("invalid title = {} (must be one line without control "
                                     "characters)",
                                     shown_text(title)));
  return title;
}

}  // namespace

SeaFile read_sea_file(const std::filesystem::path& path) {
  CaseSource source{.name = path.string(), .notices = {}, .warnings = {}};
  try {
    const std::string content = read_regular_file(path, kLargestFile);
    require_content(content, source, "sea states");
    const toml::table table = parse(content, source);
    const Section root(table, "", source, {"sea", "scatter"});
    if (!root.find("scatter")) root.require("sea", "required: sea states [[sea]], or [[scatter]]");
    SeaFile file{read_sea_states(root, path.parent_path()),
                 read_wave_climates(root, path.parent_path()),
                 {}};
    for (const wave::SeaState& sea : file.seas)
      FLOE_VALIDATE_AS(DataError, !sea.zones,
                       source.name << ": sea " << sea.name
                                   << " has zones (must stand in the case: its waves need the "
                                      "fluid's pressures, which a run does not keep)");
    file.notices = std::move(source.notices);
    return file;
  } catch (const DataError&) {
    throw;
  } catch (const InputError& error) {
    throw DataError(error.what());
  }
}

CaseFile read_case(const std::filesystem::path& path) {
  return read_case_text(read_regular_file(path, kLargestFile), path.string(), path.parent_path());
}

CaseFile read_case_text(const std::string& text, const std::string& name,
                        const std::filesystem::path& folder) {
  // Parse the text
  CaseSource source{.name = name, .notices = {}, .warnings = {}};
  require_content(text, source, "a case");
  const toml::table table = parse(text, source);
  const Section root(
      table, "", source,
      {"title", "water", "plate", "mesh", "modes", "waves", "solver", "sea_grid", "sea", "output"});
  require_sections(root);

  // Check each section and take it over
  CaseFile file;
  file.data.text = text;
  file.data.title = read_title(root);
  read_water(root, file.data);
  read_plate(root, folder, file.data);
  read_meshes(root, folder, file.data);
  read_modes(root, file.data);
  read_waves(root, file.data);
  read_solver(root, file.data);
  read_output(root, file.data);
  read_seas(root, folder, file.data);
  require_route(root, file.data);
  file.notices = std::move(source.notices);
  file.warnings = std::move(source.warnings);
  return file;
}

}  // namespace floe::io
