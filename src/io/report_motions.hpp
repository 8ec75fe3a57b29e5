#pragma once

#include <floe/io/report.hpp>

namespace floe::io {

/// Motions of the waves whose node fields are stored. Shown are the headings that have a field at
/// any frequency, and the frequencies that have one for each of these; where there is none, the
/// heading with the most fields alone. Throws StoreError when there is no field.
ReportMotions stored_motions(const Case& data, const std::vector<FrequencyResult>& results);

}  // namespace floe::io
