#pragma once

#include <floe/wave/scatter_diagram.hpp>

#include <filesystem>

namespace floe::io {

/// Reads a scatter diagram: a table with commas whose first row holds the periods [s] behind one
/// cell of text, and whose other rows hold a significant height [m] and the counts or
/// probabilities of its classes. Both are those of the classes' middles and ascend. Empty lines and
/// lines that begin with # are passed over.
/// Throws DataError with the line: text or nothing where a number belongs, a row of another length,
/// a negative count, a sum of 0, or a first cell that names another kind of period than `type`.
wave::ScatterDiagram read_scatter_diagram(const std::filesystem::path& path, wave::PeriodType type);

/// "Tz", "Tp", "Te", as case files have it.
const char* period_name(wave::PeriodType type);

}  // namespace floe::io
