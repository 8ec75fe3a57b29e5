#include "io/atomic_file.hpp"
#include "io/report_motions.hpp"

#include <floe/io/report.hpp>
#include <floe/numeric/error.hpp>
#include <floe/response/design_values.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace floe::io {
namespace {

// Place of a quantity of the case in a sea's result; those of pressure are not in it
std::ptrdiff_t place_of(const SeaResult& result, std::size_t quantity) {
  const auto at = std::find(result.quantity.begin(), result.quantity.end(), quantity);
  return at == result.quantity.end() ? -1 : at - result.quantity.begin();
}

void add_heading(const Case& data, const SeaResult& result, ReportSea& sea) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  sea.mean_heading_deg.push_back(result.mean_heading_deg);
  for (std::size_t q = 0; q < data.quantities.size(); ++q)
    for (Index i = 0; i < static_cast<Index>(data.points.size()); ++i) {
      const std::ptrdiff_t place = place_of(result, q);
      response::DesignValues values{kNone, kNone, kNone, kNone};
      if (place >= 0) {
        const auto m = result.moments[static_cast<std::size_t>(place)].row(i);
        values = response::design_values(m[0], m[2], result.duration);
      }
      sea.std.push_back(values.standard_deviation);
      sea.zero_crossing_period.push_back(values.zero_crossing_period);
      sea.significant.push_back(values.significant);
      sea.most_probable_maximum.push_back(values.most_probable_maximum);
      for (Index j = 0; j < static_cast<Index>(result.omega.size()); ++j)
        sea.spectra.push_back(place >= 0 ? result.spectra[static_cast<std::size_t>(place)](i, j)
                                         : kNone);
    }
}

// Results of one sea follow each other, one a mean heading
std::vector<ReportSea> report_seas(const StoredRun& run, bool same_mesh) {
  std::vector<ReportSea> seas;
  for (const SeaResult& result : run.seas()) {
    if (seas.empty() || seas.back().name != result.sea) {
      const auto& names = run.sea_names();
      const auto at = std::find(names.begin(), names.end(), result.sea) - names.begin();
      const bool known = at < static_cast<std::ptrdiff_t>(names.size());
      ReportSea sea;
      sea.name = result.sea;
      sea.text = known ? run.sea_descriptions()[static_cast<std::size_t>(at)] : "";
      sea.spectrum_omega = result.omega;
      seas.push_back(std::move(sea));
    }
    add_heading(run.data(), result, seas.back());
    if (!same_mesh) continue;
    MatXd& map = seas.back().deflection_std;
    map.conservativeResize(result.node_moments.rows(), map.cols() + 1);
    map.rightCols(1) = result.node_moments.col(0).cwiseSqrt();
  }
  return seas;
}

// The mesh that tells the regions may have gone since the run
std::optional<plate::PlateRegions> known_regions(const Case& data, const mesh::Q8Mesh& mesh) {
  if (data.regions.empty()) return std::nullopt;
  try {
    const plate::PlateRegions regions = plate_regions(data);
    const auto count = static_cast<Index>(regions.of_element().size());
    return count == mesh.element_count() ? std::optional(regions) : std::nullopt;
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

std::string report_page(const StoredRun& run) {
  const bool modal = run.data().route == SolverRoute::kModal;
  const mesh::Q8Mesh fluid = run.fluid_mesh(), mesh = modal ? run.mode_mesh() : fluid;
  const plate::DryModes modes = modal ? run.modes() : plate::DryModes{};
  const std::vector<FrequencyResult> results = run.frequencies();
  return report_page({.data = run.data(),
                      .mesh = mesh,
                      .fluid_nodes = fluid.node_count(),
                      .fluid_elements = fluid.element_count(),
                      .modes = modes,
                      .results = results,
                      .status = run.status(),
                      .warnings = run.warnings(),
                      .stages = run.stages(),
                      .case_text = run.case_text(),
                      .seas = report_seas(run, run.data().plate_mesh.empty()),
                      .motions = modal ? ReportMotions{} : stored_motions(run.data(), results),
                      .regions = known_regions(run.data(), mesh),
                      .seconds_before = run.seconds_before(),
                      .checks = run.checks()});
}

void write_report(const StoredRun& run, const std::filesystem::path& path) {
  write_file(path, report_page(run));
}

}  // namespace floe::io
