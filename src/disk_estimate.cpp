#include <floe/disk_estimate.hpp>
#include <floe/estimate.hpp>
#include <floe/numeric/error.hpp>
#include <floe/response/modal_basis.hpp>

#include <algorithm>

namespace floe {
namespace {

constexpr double kReal = 8.0, kComplex = 16.0;
constexpr double kComplexRow = 130.0;  // of a table: place, real part, imaginary part, magnitude
constexpr double kRealRow = 60.0;      // of a table
constexpr double kFieldBytes = 130.0;  // of a node in a field for ParaView, compressed
constexpr double kMostDefaultFields = 10;  // where the case names none
constexpr double kSeaFrequencies = 300.0;  // transfer functions, of as many headings
constexpr double kSeaSamples = 9.0;        // kept at a time

}  // namespace

double estimate_disk(const Case& data, const mesh::Q8Mesh& mesh) {
  const auto nodes = static_cast<double>(mesh.node_count());
  const auto elements = static_cast<double>(mesh.element_count());
  const double modes = data.route == SolverRoute::kModal ? data.mode_count : 0.0;
  const auto headings = static_cast<double>(data.heading_deg.size());
  const auto points = static_cast<double>(data.points.size());
  const auto quantities = static_cast<double>(data.quantities.size());
  double frequencies = 0.0;
  for (std::size_t i = 0; i < data.omega.size(); ++i)
    frequencies += data.shard.holds(i) ? 1.0 : 0.0;

  // What is read off one frequency, in a record and in a table
  double stations = points * (1.0 + quantities) + static_cast<double>(data.wave_points.size());
  for (const NamedLine& line : data.lines) stations += line.count;
  const double complex_values = headings * (stations + 2.0 * modes);
  const double one = 2.0 * kReal * modes * modes + kComplex * complex_values +
                     kRealRow * modes * modes + kComplexRow * complex_values;

  // Node fields, in a record and for ParaView
  const double fields = data.fields.empty() ? std::min(kMostDefaultFields, frequencies)
                                            : static_cast<double>(data.fields.size());
  double needed = frequencies * one + fields * nodes * (4.0 * kComplex + kFieldBytes) +
                  kReal * (2.0 * nodes + 8.0 * elements + 3.0 * nodes * modes);

  // Seas: observation, transfer functions, what is solved but not yet told, statistics
  const bool range = data.sea_grid.from && data.sea_grid.to;
  if (data.shard.holds_seas() && (range || !data.seas.empty())) {
    const double influences =
        points * static_cast<double>(std::count_if(data.quantities.begin(), data.quantities.end(),
                                                   response::is_section_force));
    const double state = modes + influences;
    double results = 0.0;
    for (const wave::SeaState& sea : data.seas)
      results += static_cast<double>(sea.mean_heading_deg.size());
    needed += kReal * nodes * modes + kComplex * state * kSeaFrequencies * kSeaFrequencies +
              kComplex * nodes * state * kSeaSamples +
              results * (8.0 * kReal * nodes +
                         points * quantities * kSeaFrequencies * (kReal + kRealRow));
    if (data.node_spectra) needed += kReal * results * kSeaFrequencies * nodes;
  }
  return needed;
}

void require_disk(double needed, double free, const std::string& place) {
  FLOE_VALIDATE_AS(
      BudgetError, needed <= free,
      "invalid disk need = " << format_bytes(needed) << " (must be at most " << format_bytes(free)
                             << ", what is free where " << place
                             << " lies; what lowers it: fewer frequencies, headings or fields)");
}

}  // namespace floe
