#include "analysis_stages.hpp"
#include "finite_checks.hpp"
#include "solution_checks.hpp"

#include <floe/coupling/modal_equation.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/hydro/wave_field.hpp>
#include <floe/numeric/blas_check.hpp>
#include <floe/plate/mindlin.hpp>
#include <floe/wave/dispersion.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace floe {
namespace {

// Total pressure under the moving plate, N × the headings listed
MatXcd total_pressure(const Case& data, const bem::PressureOperator& pressure_operator,
                      const FluidModel& fluid, const hydro::Radiation& radiation, double wavenumber,
                      const std::vector<Index>& headings, const MatXcd& amplitudes) {
  std::vector<double> heading;
  MatXcd chosen(amplitudes.rows(), static_cast<Index>(headings.size()));
  for (std::size_t i = 0; i < headings.size(); ++i) {
    heading.push_back(fluid.heading[headings[i]]);
    chosen.col(static_cast<Index>(i)) = amplitudes.col(headings[i]);
  }
  const MatXcd elevation =
      hydro::incident_elevation(fluid.integrals.mesh().nodes(), wavenumber, heading);
  return hydro::solve_diffraction(pressure_operator, elevation, data.water,
                                  residual_limit(data, fluid)) +
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

// Adds to the section forces what the modes leave out
void add_static_correction(const Case& data, const PlateModel& plate, const FluidModel& fluid,
                           const MatXcd& pressure, FrequencyResult& result) {
  MatXcd load = fluid.surface_mass.cast<Complex>() * pressure;
  if (plate.to_fluid.size() > 0) load = (plate.to_fluid.transpose().cast<Complex>() * load).eval();
  const MatXcd rest = plate.correction->displacement(load, result.omega, result.amplitudes);
  for (std::size_t q = 0; q < data.quantities.size(); ++q)
    if (response::is_section_force(data.quantities[q]))
      result.point_quantities[q] +=
          plate.points.evaluate_displacement(data.quantities[q], result.omega, rest);
}

// Fills in what needs the pressure on the plate: section forces, pressures, wave points, node
// fields
void add_pressure_results(const Case& data, const PlateModel& plate, const FluidModel& fluid,
                          const bem::PressureOperator& pressure_operator,
                          const green::GreenTable& green, const hydro::Radiation& radiation,
                          FrequencyResult& result) {
  // Solve the diffraction problem of those headings only whose pressure is wanted
  const std::vector<Index> fields = field_headings(data, result.omega);
  const bool all = wants_pressure(data);
  std::vector<Index> headings = fields;
  if (all) {
    headings.resize(fluid.heading.size());
    std::iota(headings.begin(), headings.end(), Index{0});
  }
  if (headings.empty()) return;
  const MatXcd pressure = total_pressure(data, pressure_operator, fluid, radiation,
                                         result.wavenumber, headings, result.amplitudes);

  if (all) add_pressures(data, fluid, pressure, result);
  if (plate.correction) add_static_correction(data, plate, fluid, pressure, result);
  add_wave_elevation(data, fluid, green, pressure, result);
  for (const Index b : fields) {
    const auto column = std::find(headings.begin(), headings.end(), b) - headings.begin();
    result.fields.push_back(make_field(plate, result.omega, data.heading_deg[b],
                                       result.amplitudes.col(b), pressure.col(column)));
  }
}

// Deflection everywhere and the structural quantities at the points, from the modes alone
void read_off_modes(const Case& data, const PlateModel& plate, FrequencyResult& result) {
  const auto deflection = response::Quantity::kDeflection;
  result.point_deflection = plate.points.evaluate(deflection, result.omega, result.amplitudes);
  result.line_deflection = plate.lines.evaluate(deflection, result.omega, result.amplitudes);
  result.point_quantities.resize(data.quantities.size());
  for (std::size_t q = 0; q < data.quantities.size(); ++q)
    if (response::is_structural(data.quantities[q]))
      result.point_quantities[q] =
          plate.points.evaluate(data.quantities[q], result.omega, result.amplitudes);
}

}  // namespace

bool wants_pressure(const Case& data) {
  return !data.wave_points.empty() ||
         std::any_of(data.quantities.begin(), data.quantities.end(), [](response::Quantity q) {
           return !response::is_structural(q) || response::is_section_force(q);
         });
}

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

void add_pressures(const Case& data, const FluidModel& fluid, const MatXcd& pressure,
                   FrequencyResult& result) {
  for (std::size_t q = 0; q < data.quantities.size(); ++q) {
    if (response::is_structural(data.quantities[q])) continue;
    const bool relative = data.quantities[q] == response::Quantity::kRelativeElevation;
    const double scale = relative ? 1.0 / (data.water.density * data.water.gravity) : 1.0;
    result.point_quantities[q] = scale * (fluid.at_points.cast<Complex>() * pressure);
  }
}

void add_wave_elevation(const Case& data, const FluidModel& fluid, const green::GreenTable& green,
                        const MatXcd& pressure, FrequencyResult& result) {
  if (data.wave_points.empty()) return;
  const MatXcd incident =
      hydro::incident_elevation(fluid.wave_points, result.wavenumber, fluid.heading);
  result.wave_elevation = hydro::wave_elevation(fluid.integrals, green, data.water,
                                                fluid.wave_points, incident, pressure);
}

// The residual that a solution must have. A direct one is good to rounding times the condition
// number, which stays below 1e4
double residual_limit(const Case& data, const FluidModel& fluid) {
  return fluid.operators.method == SolverMethod::kDense ? 1e-10 : 1.001 * data.tolerance;
}

FrequencyResult solve_frequency(const Case& data, const PlateModel& plate, const FluidModel& fluid,
                                double omega, StageClock& clock) {
  const auto start = std::chrono::steady_clock::now();
  FrequencyResult result;
  result.omega = omega;
  result.wavenumber = wave::wavenumber(omega, data.water);
  result.report.omega = omega;
  result.report.processor = numeric::processor_kind();

  // Set up the fluid's operator
  const green::GreenTable green = clock.time("Green function", [&] {
    const double nu = wave::deep_wavenumber(omega, data.water);
    return green::GreenTable(green::GreenFunction(nu, data.water.depth), fluid.reach);
  });
  const auto pressure_operator =
      clock.time("operator", [&] { return make_operator(data, fluid, green); });

  // Radiate every mode, get the exciting forces from reciprocity
  const hydro::Radiation radiation = clock.time("radiation", [&] {
    return hydro::solve_radiation(*pressure_operator, fluid.deflection, fluid.surface_mass, omega,
                                  data.water, residual_limit(data, fluid));
  });
  clock.time("exciting forces", [&] {
    const MatXcd loads =
        hydro::wave_loads(fluid.integrals.mesh(), result.wavenumber, fluid.heading);
    result.exciting_force = hydro::exciting_forces(radiation.pressure, loads);
    result.froude_krylov_force = hydro::froude_krylov_forces(fluid.deflection, loads, data.water);
  });

  // Couple plate and fluid, read off the response
  clock.time("response", [&] {
    result.amplitudes = coupling::modal_amplitudes(plate.modes, data.plate.loss_factor, omega,
                                                   radiation.fluid_matrix, result.exciting_force);
    read_off_modes(data, plate, result);
    add_pressure_results(data, plate, fluid, *pressure_operator, green, radiation, result);
  });

  // Say what it is worth
  result.added_mass = radiation.added_mass;
  result.damping = radiation.damping;
  result.report.method = pressure_operator->method();
  clock.time("self-checks", [&] {
    judge_radiation(data, fluid, green, radiation, radiation.pressure, result.report);
    result.report.mode_change = change_by_modes(data, plate, fluid, omega, radiation.fluid_matrix,
                                                result.exciting_force, result.amplitudes);
  });
  require_finite(result);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  result.report.seconds = elapsed.count();
  return result;
}

}  // namespace floe
