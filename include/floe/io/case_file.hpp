#pragma once

#include <floe/analysis.hpp>
#include <floe/wave/scatter_diagram.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace floe::io {

/// A case as it was read, with what the user should know about the reading.
struct CaseFile {
  Case data;
  std::vector<std::string> notices;   ///< something was repaired: frequencies sorted, and the like
  std::vector<std::string> warnings;  ///< something looks like a mistake
};

/// Reads a case file (TOML, SI units, degrees in keys that end in `_deg`).
/// Every key is checked; relative paths are taken from the case file's folder; wavenumbers and
/// wavelengths become frequencies by (W.2).
/// Throws InputError `CASE.toml:line:column: what = value unit (what is required)`, also when the
/// file is no regular file, cannot be read or is larger than 16 MiB; MeshError when a mesh file
/// that it names is not there; BudgetError when it asks for more than 100 000 frequencies.
CaseFile read_case(const std::filesystem::path& path);

/// The same for a case that is at hand as text; `name` stands in messages for the file's, `folder`
/// is where relative paths begin.
CaseFile read_case_text(const std::string& text, const std::string& name,
                        const std::filesystem::path& folder);

/// The sea states and wave climates of a file of its own.
struct SeaFile {
  std::vector<wave::SeaState> seas;
  std::vector<wave::WaveClimate> climates;
  std::vector<std::string> notices;  ///< something was repaired
};

/// Reads the `[[sea]]` and `[[scatter]]` sections of a file that holds nothing else; paths of
/// tables are taken from its folder. Throws DataError with the place, also when there is none of
/// both.
SeaFile read_sea_file(const std::filesystem::path& path);

/// The name among `known` that is closest to `name`, or "" if none is close: at most a third of its
/// letters wrong (a swap of neighbours counts as one).
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace floe::io
