#include "analysis_stages.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <floe/bem/dense_pressure_operator.hpp>
#include <floe/coupling/modal_equation.hpp>
#include <floe/estimate.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/hydro/wave_field.hpp>
#include <floe/mesh/gmsh.hpp>
#include <floe/numeric/error.hpp>
#include <floe/preflight.hpp>
#include <floe/plate/mindlin.hpp>
#include <floe/response/stations.hpp>
#include <floe/wave/dispersion.hpp>
#include <numbers>

namespace floe {
namespace {

// A direct solution is good to rounding times the condition number, which stays below 1e4
constexpr double kDenseResidualLimit = 1e-10;

mesh::Q8Mesh load_mesh(const MeshSource& source, Log& log) {
  if (const auto* rectangle = std::get_if<mesh::RectangleOptions>(&source))
    return mesh::make_rectangle(*rectangle);
  mesh::MeshFile file = mesh::read_gmsh(std::get<std::filesystem::path>(source));
  for (const std::string& notice : file.notices) log.notice(notice);
  return std::move(file.mesh);
}

std::vector<std::string> names_of(const std::vector<NamedPoint>& points) {
  std::vector<std::string> names;
  for (const NamedPoint& point : points) names.push_back(point.name);
  return names;
}

Points2 positions_of(const std::vector<NamedPoint>& points) {
  Points2 positions(2, static_cast<Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    positions.col(static_cast<Index>(i)) = points[i].position;
  return positions;
}

// Stations of all lines, one after the other
SparseMatrix interpolation_to_lines(const mesh::Q8Mesh& mesh, const std::vector<NamedLine>& lines) {
  std::vector<std::string> names;
  std::vector<Point2> positions;
  for (const NamedLine& line : lines) {
    const Points2 stations = response::line_stations(line.from, line.to, line.count);
    for (int i = 0; i < line.count; ++i) {
      names.push_back(fmt::format("{} of line {}", i + 1, line.name));
      positions.emplace_back(stations.col(i));
    }
  }
  Points2 all(2, static_cast<Index>(positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i) all.col(static_cast<Index>(i)) = positions[i];
  return response::interpolation_to(mesh, all, names);
}

// Headings whose node fields are wanted at this frequency; nothing asked for means the first
// heading at ten frequencies at most, evenly spread
std::vector<Index> field_headings(const Case& data, double omega) {
  std::vector<Index> wanted;
  if (data.fields.empty()) {
    const auto count = static_cast<Index>(data.omega.size());
    const auto at = std::find(data.omega.begin(), data.omega.end(), omega) - data.omega.begin();
    const Index most = std::min<Index>(10, count);
    for (Index i = 0; i < most; ++i)
      if (at == (most > 1 ? i * (count - 1) / (most - 1) : 0)) wanted.push_back(0);
    return wanted;
  }
  for (const FieldRequest& request : data.fields)
    for (std::size_t b = 0; b < data.heading_deg.size(); ++b)
      if (request.heading_deg == data.heading_deg[b] &&
          std::abs(request.omega - omega) <= 1e-9 * omega)
        wanted.push_back(static_cast<Index>(b));
  return wanted;
}

bool wants_pressure(const Case& data) {
  return std::any_of(data.quantities.begin(), data.quantities.end(), [](response::Quantity q) {
    return !response::ModalBasis::is_modal(q);
  });
}

// Total pressure under the moving plate, N × the headings listed
MatXcd total_pressure(const bem::PressureOperator& pressure_operator, const FluidModel& fluid,
                      const hydro::Radiation& radiation, const wave::Water& water,
                      double wavenumber, const std::vector<Index>& headings,
                      const MatXcd& amplitudes) {
  std::vector<double> heading;
  MatXcd chosen(amplitudes.rows(), static_cast<Index>(headings.size()));
  for (std::size_t i = 0; i < headings.size(); ++i) {
    heading.push_back(fluid.heading[headings[i]]);
    chosen.col(static_cast<Index>(i)) = amplitudes.col(headings[i]);
  }
  const MatXcd elevation =
      hydro::incident_elevation(fluid.integrals.mesh().nodes(), wavenumber, heading);
  return hydro::solve_diffraction(pressure_operator, elevation, water, kDenseResidualLimit) +
         radiation.pressure * chosen;
}

NodeField make_field(const PlateModel& plate, double omega, double heading_deg,
                     const VecXcd& amplitudes, const VecXcd& pressure) {
  const VecXcd displacement = plate.fluid_modes.shape.cast<Complex>() * amplitudes;
  const auto part = [&](Index first) {
    return VecXcd(displacement(Eigen::seq(first, Eigen::last, plate::kUnknownsPerNode)));
  };
  return {omega, heading_deg, part(0), part(1), part(2), pressure};
}

// Fills in what needs the pressure on the plate: pressure quantities, wave points, node fields
void add_pressure_results(const Case& data, const PlateModel& plate, const FluidModel& fluid,
                          const bem::PressureOperator& pressure_operator,
                          const green::GreenTable& green, const hydro::Radiation& radiation,
                          FrequencyResult& result) {
  // Solve the diffraction problem of those headings only whose pressure is wanted
  const std::vector<Index> fields = field_headings(data, result.omega);
  const bool all = wants_pressure(data) || !data.wave_points.empty();
  std::vector<Index> headings = fields;
  if (all) {
    headings.clear();
    for (std::size_t b = 0; b < fluid.heading.size(); ++b) headings.push_back(static_cast<Index>(b));
  }
  if (headings.empty()) return;
  const MatXcd pressure = total_pressure(pressure_operator, fluid, radiation, data.water,
                                         result.wavenumber, headings, result.amplitudes);

  for (std::size_t q = 0; q < data.quantities.size(); ++q) {
    if (response::ModalBasis::is_modal(data.quantities[q])) continue;
    const bool relative = data.quantities[q] == response::Quantity::kRelativeElevation;
    const double scale = relative ? 1.0 / (data.water.density * data.water.gravity) : 1.0;
    result.point_quantities[q] = scale * (fluid.at_points.cast<Complex>() * pressure);
  }
  if (!data.wave_points.empty()) {
    const MatXcd incident =
        hydro::incident_elevation(fluid.wave_points, result.wavenumber, fluid.heading);
    result.wave_elevation = hydro::wave_elevation(fluid.integrals, green, data.water,
                                                  fluid.wave_points, incident, pressure);
  }
  for (const Index b : fields) {
    const auto column = std::find(headings.begin(), headings.end(), b) - headings.begin();
    result.fields.push_back(make_field(plate, result.omega, data.heading_deg[b],
                                       result.amplitudes.col(b), pressure.col(column)));
  }
}

}  // namespace

void StageClock::add(const std::string& stage, std::chrono::duration<double> elapsed) {
  auto at = std::find_if(times_.begin(), times_.end(),
                         [&](const StageTime& time) { return time.stage == stage; });
  if (at == times_.end()) at = times_.insert(times_.end(), {stage, 0.0, 0.0});
  at->seconds += elapsed.count();
  at->peak_memory = numeric::peak_memory();
}

Meshes prepare_meshes(const Case& data, Log& log) {
  Meshes meshes{load_mesh(data.mesh, log), std::nullopt};
  if (!data.plate_mesh.empty()) meshes.own_plate = load_mesh(data.plate_mesh.front(), log);

  // Refuse what is too coarse or too large before anything is computed
  const Preflight found =
      preflight(data, meshes.fluid, meshes.own_plate ? &*meshes.own_plate : nullptr);
  for (const std::string& warning : found.warnings) log.warning(warning);
  require_resolution(data, found);
  require_budget(estimate(data, meshes.fluid, omp_get_max_threads()),
                 numeric::memory_budget(data.memory_limit, numeric::memory_limits()));
  return meshes;
}

PlateModel prepare_plate(const Case& data, const Meshes& meshes, Log& log) {
  const mesh::Q8Mesh& mesh = meshes.plate();
  const SparseMatrix at_points =
      response::interpolation_to(mesh, positions_of(data.points), names_of(data.points));
  const SparseMatrix at_lines = interpolation_to_lines(mesh, data.lines);
  plate::DryModes modes = plate::dry_modes(mesh, data.plate, {.count = data.mode_count});
  plate::DryModes fluid_modes =
      meshes.own_plate ? plate::interpolate_modes(modes, mesh, meshes.fluid) : modes;
  response::ModalBasis points(mesh, data.plate, modes, at_points, data.quantities);
  response::ModalBasis lines(mesh, data.plate, modes, at_lines, {});
  log.info(fmt::format("modes      {} ({} rigid), the highest {:.4g} rad/s to {:.1g} relative",
                       modes.count(), modes.rigid_count, modes.omega.maxCoeff(),
                       modes.estimated_frequency_error));
  return {std::move(modes), std::move(fluid_modes), std::move(points), std::move(lines)};
}

FluidModel prepare_fluid(const Case& data, const Meshes& meshes, const PlateModel& plate) {
  const mesh::Q8Mesh& mesh = meshes.fluid;
  FluidModel fluid{
      .integrals = bem::ElementIntegrals(mesh),
      .surface_mass = hydro::surface_mass(mesh),
      .deflection = plate.fluid_modes.shape(Eigen::seq(0, Eigen::last, plate::kUnknownsPerNode),
                                            Eigen::all),
      .at_points =
          response::interpolation_to(mesh, positions_of(data.points), names_of(data.points)),
      .wave_points = positions_of(data.wave_points),
      .heading = {},
      .reach = 0.0};
  for (const double degrees : data.heading_deg)
    fluid.heading.push_back(degrees * std::numbers::pi / 180.0);

  Point2 lower = mesh.lower(), upper = mesh.upper();
  for (Index i = 0; i < fluid.wave_points.cols(); ++i) {
    lower = lower.cwiseMin(fluid.wave_points.col(i));
    upper = upper.cwiseMax(fluid.wave_points.col(i));
  }
  fluid.reach = 1.001 * (upper - lower).norm();
  return fluid;
}

FrequencyResult solve_frequency(const Case& data, const PlateModel& plate, const FluidModel& fluid,
                                double omega, StageClock& clock) {
  const auto start = std::chrono::steady_clock::now();
  FrequencyResult result;
  result.omega = omega;
  result.wavenumber = wave::wavenumber(omega, data.water);
  result.report.omega = omega;

  // Set up the fluid's operator
  const green::GreenTable green = clock.time("Green function", [&] {
    const double nu = wave::deep_wavenumber(omega, data.water);
    return green::GreenTable(green::GreenFunction(nu, data.water.depth), fluid.reach);
  });
  const auto pressure_operator = clock.time("operator", [&] {
    return std::make_unique<const bem::DensePressureOperator>(fluid.integrals, green);
  });

  // Radiate every mode, get the exciting forces from reciprocity
  const hydro::Radiation radiation = clock.time("radiation", [&] {
    return hydro::solve_radiation(*pressure_operator, fluid.deflection, fluid.surface_mass, omega,
                                  data.water, kDenseResidualLimit);
  });
  clock.time("exciting forces", [&] {
    result.exciting_force = hydro::exciting_forces(
        radiation.pressure,
        hydro::wave_loads(fluid.integrals.mesh(), result.wavenumber, fluid.heading));
    result.report.energy_error = hydro::energy_error(
        radiation, hydro::radiated_damping(radiation.pressure, fluid.integrals.mesh(), omega, data.water),
        omega);
  });

  // Couple plate and fluid, read off the response
  clock.time("response", [&] {
    result.amplitudes =
        coupling::modal_amplitudes(plate.modes, data.plate.loss_factor, omega,
                                   radiation.fluid_matrix, result.exciting_force);
    const auto deflection = response::Quantity::kDeflection;
    result.point_deflection = plate.points.evaluate(deflection, omega, result.amplitudes);
    result.line_deflection = plate.lines.evaluate(deflection, omega, result.amplitudes);
    result.point_quantities.resize(data.quantities.size());
    for (std::size_t q = 0; q < data.quantities.size(); ++q)
      if (response::ModalBasis::is_modal(data.quantities[q]))
        result.point_quantities[q] =
            plate.points.evaluate(data.quantities[q], omega, result.amplitudes);
    add_pressure_results(data, plate, fluid, *pressure_operator, green, radiation, result);
  });

  // Say what it is worth
  result.added_mass = radiation.added_mass;
  result.damping = radiation.damping;
  result.report.method = pressure_operator->method();
  result.report.applications = 2 * radiation.pressure.cols();
  result.report.true_residual = radiation.true_residual;
  result.report.kernel_error = green.sampled_error(200);
  result.report.reciprocity_error = hydro::reciprocity_error(radiation, omega);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  result.report.seconds = elapsed.count();
  return result;
}

}  // namespace floe
