#include "io/report_motions.hpp"

#include <floe/numeric/error.hpp>

#include <algorithm>

namespace floe::io {
namespace {

const NodeField* field_of(const FrequencyResult& result, double heading_deg) {
  const auto at =
      std::find_if(result.fields.begin(), result.fields.end(),
                   [&](const NodeField& field) { return field.heading_deg == heading_deg; });
  return at == result.fields.end() ? nullptr : &*at;
}

std::vector<std::size_t> frequencies_with(const std::vector<FrequencyResult>& results,
                                          const std::vector<double>& heading_deg,
                                          const std::vector<std::size_t>& headings) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < results.size(); ++i)
    if (std::all_of(headings.begin(), headings.end(),
                    [&](std::size_t b) { return field_of(results[i], heading_deg[b]); }))
      found.push_back(i);
  return found;
}

// Displacements of one field, 3N
VecXcd displacement(const NodeField& field) {
  VecXcd motion(3 * field.deflection.size());
  for (Index node = 0; node < field.deflection.size(); ++node)
    motion.segment<3>(3 * node) << field.deflection[node], field.rotation_x[node],
        field.rotation_y[node];
  return motion;
}

}  // namespace

ReportMotions stored_motions(const Case& data, const std::vector<FrequencyResult>& results) {
  // Choose the waves
  const std::vector<double>& heading_deg = data.heading_deg;
  ReportMotions motions;
  std::size_t most = 0, favourite = 0;
  for (std::size_t b = 0; b < heading_deg.size(); ++b) {
    const std::size_t count = frequencies_with(results, heading_deg, {b}).size();
    if (count > 0) motions.headings.push_back(b);
    if (count > most) favourite = b;
    most = std::max(most, count);
  }
  FLOE_VALIDATE_AS(StoreError, most > 0,
                   "no node field is stored (a run of the direct route must have output.fields "
                   "to be shown)");
  motions.frequencies = frequencies_with(results, heading_deg, motions.headings);
  if (motions.frequencies.empty()) {
    motions.headings = {favourite};
    motions.frequencies = frequencies_with(results, heading_deg, motions.headings);
  }

  // Take their motions
  for (const std::size_t i : motions.frequencies)
    for (const std::size_t b : motions.headings) {
      const VecXcd motion = displacement(*field_of(results[i], heading_deg[b]));
      motions.parts.conservativeResize(motion.size(), motions.parts.cols() + 2);
      motions.parts.rightCols(2) << motion.real(), motion.imag();
    }
  return motions;
}

}  // namespace floe::io
