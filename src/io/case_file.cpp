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

toml::table parse(const std::string& content, const CaseSource& source) {
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

std::string read_text(const CaseSource& source, const std::filesystem::path& path,
                      const std::string& what) {
  std::string content = read_regular_file(path, kLargestFile);
  FLOE_VALIDATE(content.find_first_not_of(" \t\r\n") != std::string::npos,
                source.name << ": the file is empty (must hold " << what << ")");
  return content;
}

void require_sections(const Section& root) {
  for (const char* name : {"water", "plate", "mesh", "waves"})
    root.require(name, fmt::format("a section [{}] is required", name));
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
    const toml::table table = parse(read_text(source, path, "sea states"), source);
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
  // Read and parse the file
  CaseSource source{.name = path.string(), .notices = {}, .warnings = {}};
  const std::string content = read_text(source, path, "a case");
  const toml::table table = parse(content, source);
  const Section root(
      table, "", source,
      {"title", "water", "plate", "mesh", "modes", "waves", "solver", "sea_grid", "sea", "output"});
  require_sections(root);

  // Check each section and take it over
  CaseFile file;
  file.data.text = content;
  file.data.title = read_title(root);
  read_water(root, file.data);
  read_plate(root, file.data);
  read_meshes(root, path.parent_path(), file.data);
  read_modes(root, file.data);
  read_waves(root, file.data);
  read_solver(root, file.data);
  read_output(root, file.data);
  read_seas(root, path.parent_path(), file.data);
  file.notices = std::move(source.notices);
  file.warnings = std::move(source.warnings);
  return file;
}

}  // namespace floe::io
