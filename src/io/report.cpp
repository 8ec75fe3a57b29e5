#include "io/packed_array.hpp"
#include "io/report_moments.hpp"
#include "io/report_template.hpp"

#include <floe/io/report.hpp>
#include <floe/mesh/drawing.hpp>
#include <floe/numeric/error.hpp>
#include <floe/self_checks.hpp>

#include <algorithm>
#include <cmath>

namespace floe::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kPageBytes = 5e6;
constexpr double kBytesPerNumber = 8.0 / 3.0;  // 16 bits in base64
constexpr Index kMostNodes = 6000;

// Waves that the page shows, by their places
struct Shown {
  std::vector<std::size_t> frequencies, headings;
};

// All, or every n-th frequency where they would not fit; on the direct route those whose motions
// are known
Shown shown_waves(const ReportContent& content) {
  if (content.data.route == SolverRoute::kDirect)
    return {content.motions.frequencies, content.motions.headings};
  const auto headings = static_cast<double>(content.data.heading_deg.size());
  Index stations = 0;
  for (const NamedLine& line : content.data.lines) stations += line.count;
  const double numbers = 2.0 * headings *
                         static_cast<double>(content.modes.count() + stations +
                                             static_cast<Index>(content.data.quantities.size() *
                                                                content.data.points.size()));
  const double bytes = numbers * kBytesPerNumber * static_cast<double>(content.results.size());
  const auto stride =
      static_cast<std::size_t>(std::max(1.0, std::ceil(bytes / (0.4 * kPageBytes))));
  Shown shown;
  for (std::size_t i = 0; i < content.results.size(); i += stride) shown.frequencies.push_back(i);
  for (std::size_t b = 0; b < content.data.heading_deg.size(); ++b) shown.headings.push_back(b);
  return shown;
}

// Shapes of which every shown motion is a sum
const MatXd& shapes_of(const ReportContent& content) {
  const bool modal = content.data.route == SolverRoute::kModal;
  return modal ? content.modes.shape : content.motions.parts;
}

// Appends rows × headings, headings outermost: [heading][row][re, im]
void append(const Eigen::Ref<const MatXcd>& values, const Shown& shown,
            std::vector<double>& numbers) {
  for (const std::size_t heading : shown.headings)
    for (Index row = 0; row < values.rows(); ++row) {
      const Complex value = values(row, static_cast<Index>(heading));
      numbers.push_back(value.real());
      numbers.push_back(value.imag());
    }
}

Json waves_json(const ReportContent& content, const Shown& shown) {
  Json omega = Json::array(), wavenumber = Json::array(), heading_deg = Json::array();
  for (const std::size_t b : shown.headings) heading_deg.push_back(content.data.heading_deg[b]);
  for (const std::size_t i : shown.frequencies) {
    omega.push_back(content.results[i].omega);
    wavenumber.push_back(content.results[i].wavenumber);
  }
  return {{"omega", omega},
          {"wavenumber", wavenumber},
          {"heading_deg", heading_deg},
          {"computed", content.results.size() * content.data.heading_deg.size()}};
}

Json surface_json(const ReportContent& content, const mesh::Drawing& drawing) {
  std::vector<double> x, y;
  for (const Index node : drawing.nodes) {
    x.push_back(content.mesh.nodes()(0, node));
    y.push_back(content.mesh.nodes()(1, node));
  }
  std::vector<std::uint32_t> triangles, edges;
  for (const auto& t : drawing.triangles) triangles.insert(triangles.end(), t.begin(), t.end());
  for (const auto& e : drawing.outline) edges.insert(edges.end(), e.begin(), e.end());
  return {{"x", packed_floats(x)},
          {"y", packed_floats(y)},
          {"triangles", packed_indices(triangles)},
          {"edges", packed_indices(edges)}};
}

// [mode][node], one scale a mode would not be worth its code: modes are mass-normalised
Json modes_json(const ReportContent& content, const mesh::Drawing& drawing) {
  std::vector<double> shape;
  const MatXd& shapes = shapes_of(content);
  for (Index mode = 0; mode < shapes.cols(); ++mode)
    for (const Index node : drawing.nodes) shape.push_back(shapes(3 * node, mode));
  const VecXd& omega = content.modes.omega;
  return {{"omega", std::vector<double>(omega.data(), omega.data() + omega.size())},
          {"count", shapes.cols()},
          {"shape", packed_short(shape)}};
}

Json structure_json(const ReportContent& content) {
  const auto& [depth, density, gravity] = content.data.water;
  const Point2 extent = content.mesh.upper() - content.mesh.lower();
  const plate::PlateProperties& plate = content.data.plate;
  double thinnest = plate.thickness, thickest = plate.thickness;
  for (const PlateRegion& region : content.data.regions) {
    thinnest = std::min(thinnest, region.properties.thickness);
    thickest = std::max(thickest, region.properties.thickness);
  }
  return {{"nodes", content.fluid_nodes},
          {"elements", content.fluid_elements},
          {"pieces", content.mesh.piece_count()},
          {"area", content.mesh.area()},
          {"extent", {extent.x(), extent.y()}},
          {"plate",
           {{"thickness", {thinnest, thickest}},
            {"youngs_modulus", plate.youngs_modulus},
            {"poisson_ratio", plate.poisson_ratio},
            {"density", plate.density},
            {"loss_factor", plate.loss_factor}}},
          {"water",
           {{"depth", std::isinf(depth) ? Json(nullptr) : Json(depth)},
            {"density", density},
            {"gravity", gravity}}}};
}

Json points_json(const ReportContent& content) {
  Json points = Json::array();
  for (const NamedPoint& point : content.data.points)
    points.push_back({{"name", point.name}, {"x", point.position.x()}, {"y", point.position.y()}});
  return points;
}

Json quantities_json(const ReportContent& content) {
  Json quantities = Json::array();
  for (const response::Quantity quantity : content.data.quantities) {
    const std::string unit(response::unit(quantity));
    quantities.push_back({{"name", response::name(quantity)},
                          {"label", response::label(quantity)},
                          {"unit", unit},
                          {"per_metre", response::unit_per_metre(quantity)}});
  }
  return quantities;
}

// One array a quantity: [frequency][heading][point][re, im]
Json rao_json(const ReportContent& content, const Shown& shown) {
  Json all = Json::array();
  for (std::size_t q = 0; q < content.data.quantities.size(); ++q) {
    std::vector<double> numbers;
    for (const std::size_t i : shown.frequencies)
      append(content.results[i].point_quantities[q], shown, numbers);
    all.push_back(packed_short(numbers));
  }
  return all;
}

// One array a line: [frequency][heading][station][re, im]
Json lines_json(const ReportContent& content, const Shown& shown) {
  Json lines = Json::array();
  Index first = 0;
  for (const NamedLine& line : content.data.lines) {
    const double length = (line.to - line.from).norm();
    Json stations = Json::array();
    for (int s = 0; s < line.count; ++s)
      stations.push_back(line.count > 1 ? length * s / (line.count - 1) : 0.0);
    std::vector<double> numbers;
    for (const std::size_t i : shown.frequencies)
      append(content.results[i].line_deflection.middleRows(first, line.count), shown, numbers);
    first += line.count;
    lines.push_back({{"name", line.name}, {"s", stations}, {"deflection", packed_short(numbers)}});
  }
  return lines;
}

// How much of every shape each wave has: [frequency][heading][shape][re, im]. Without modes a wave
// is 1 of its real part and i of its imaginary part
Json amplitudes_json(const ReportContent& content, const Shown& shown) {
  std::vector<double> numbers;
  if (content.data.route == SolverRoute::kModal) {
    for (const std::size_t i : shown.frequencies)
      append(content.results[i].amplitudes, shown, numbers);
    return packed_short(numbers);
  }
  const std::size_t waves = shown.frequencies.size() * shown.headings.size();
  numbers.resize(4 * waves * waves);
  for (std::size_t wave = 0; wave < waves; ++wave) {
    double* const own = numbers.data() + 4 * (wave * waves + wave);
    own[0] = own[3] = 1.0;
  }
  return packed_short(numbers);
}

// Heave, roll and pitch of the first plate: [frequency][mode]
Json hydrodynamics_json(const ReportContent& content, const Shown& shown) {
  if (content.data.route == SolverRoute::kDirect) return nullptr;
  Json mass = Json::array(), damping = Json::array();
  for (const std::size_t i : shown.frequencies)
    for (Index mode = 0; mode < 3; ++mode) {
      mass.push_back(content.results[i].added_mass(mode, mode));
      damping.push_back(content.results[i].damping(mode, mode));
    }
  return {{"added_mass", mass}, {"damping", damping}};
}

std::vector<SelfCheck> checks_of(const ReportContent& content) {
  if (!content.checks.empty()) return content.checks;
  std::vector<FrequencyReport> reports;
  for (const FrequencyResult& result : content.results) reports.push_back(result.report);
  return self_checks(content.data, preflight(content.data, content.mesh).resolution, content.modes,
                     reports, {});
}

Json checks_json(const ReportContent& content) {
  Json checks = Json::array();
  for (const SelfCheck& check : checks_of(content))
    checks.push_back({{"name", check.name},
                      {"value", check.value},
                      {"threshold", check.limit},
                      {"omega", check.omega},
                      {"status", status_name(check.status)},
                      {"text", check.meaning}});
  return checks;
}

Json account_json(const ReportContent& content) {
  Json frequencies = Json::array(), stages = Json::array();
  for (const FrequencyResult& result : content.results) {
    const FrequencyReport& r = result.report;
    frequencies.push_back({{"omega", r.omega},
                           {"method", r.method},
                           {"iterations", r.iterations},
                           {"true_residual", r.true_residual},
                           {"kernel_error", r.kernel_error},
                           {"reciprocity_error", r.reciprocity_error},
                           {"energy_error", r.energy_error},
                           {"seconds", r.seconds}});
  }
  for (const StageTime& stage : content.stages)
    stages.push_back(
        {{"stage", stage.stage}, {"seconds", stage.seconds}, {"peak_memory", stage.peak_memory}});
  return {
      {"convergence", frequencies}, {"stages", stages}, {"seconds_before", content.seconds_before}};
}

Json sea_json(const ReportSea& sea, const mesh::Drawing& drawing) {
  Json json = {{"name", sea.name},
               {"text", sea.text},
               {"mean_heading_deg", sea.mean_heading_deg},
               {"statistics",
                {{"std", sea.std},
                 {"zero_crossing_period", sea.zero_crossing_period},
                 {"significant", sea.significant},
                 {"most_probable_maximum", sea.most_probable_maximum}}}};
  if (!sea.spectra.empty())
    json["spectra"] = {{"omega", sea.spectrum_omega}, {"values", packed_floats(sea.spectra)}};
  if (sea.deflection_std.size() > 0) {
    std::vector<double> map;
    for (Index mean = 0; mean < sea.deflection_std.cols(); ++mean)
      for (const Index node : drawing.nodes) map.push_back(sea.deflection_std(node, mean));
    json["std_map"] = packed_short(map);
  }
  return json;
}

Json page_json(const ReportContent& content) {
  const Shown shown = shown_waves(content);
  // Deflection and two moments of every mode at every drawn node
  const auto fitting =
      static_cast<Index>(0.4 / 3.0 * kPageBytes / kBytesPerNumber /
                         static_cast<double>(std::max<Index>(1, shapes_of(content).cols())));
  const mesh::Drawing drawing = mesh::make_drawing(content.mesh, std::min(kMostNodes, fitting));
  Json page = {{"format", 1},
               {"program", {{"name", "floe"}, {"version", FLOE_VERSION}}},
               {"title", content.data.title},
               {"status", content.status},
               {"route", route_name(content.data.route)},
               {"method", content.results.empty() ? "" : content.results.front().report.method},
               {"structure", structure_json(content)},
               {"waves", waves_json(content, shown)},
               {"points", points_json(content)},
               {"quantities", quantities_json(content)},
               {"rao", rao_json(content, shown)},
               {"lines", lines_json(content, shown)},
               {"surface", surface_json(content, drawing)},
               {"modes", modes_json(content, drawing)},
               {"moments", moments_json(content, shapes_of(content), drawing)},
               {"amplitudes", amplitudes_json(content, shown)},
               {"hydrodynamics", hydrodynamics_json(content, shown)},
               {"checks", checks_json(content)},
               {"warnings", content.warnings},
               {"case_text", content.case_text},
               {"seas", Json::array()}};
  page.update(account_json(content));
  for (const ReportSea& sea : content.seas) page["seas"].push_back(sea_json(sea, drawing));
  return page;
}

// Text inside a <script> must not end it or open a comment
std::string safe_in_script(const std::string& json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

}  // namespace

std::string report_page(const ReportContent& content) {
  if (content.results.empty())
    throw InputError("no finished frequency to report (run the case first)");
  const std::string json = page_json(content).dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string page(kReportTemplate);
  const std::string place = "@DATA@";
  page.replace(page.find(place), place.size(), safe_in_script(json));
  return page;
}

bool report_available() { return !kReportTemplate.empty(); }

}  // namespace floe::io
