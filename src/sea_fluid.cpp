#include "sea_fluid.hpp"

#include "solution_checks.hpp"

#include <floe/coupling/modal_equation.hpp>
#include <floe/hydro/point_pressure.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/wave/dispersion.hpp>

#include <algorithm>
#include <numbers>

namespace floe {
namespace {

// What is left out of the section forces at the points, in the order of the quantities
plate::StaticCorrection::Influence influences(const Case& data, const PlateModel& plate,
                                              const FluidModel& fluid) {
  plate::StaticCorrection::Influence all;
  all.constant.resize(fluid.deflection.rows(), 0);
  all.slope = all.constant;
  const auto append = [&](MatXd& to, const MatXd& from) {
    to.conservativeResize(Eigen::NoChange, to.cols() + from.cols());
    to.rightCols(from.cols()) = plate.to_fluid.size() > 0 ? MatXd(plate.to_fluid * from) : from;
  };
  for (const response::Quantity quantity : data.quantities) {
    if (!response::is_section_force(quantity)) continue;
    const auto own = plate.correction->influence(plate.points.section_force(quantity));
    append(all.constant, own.constant);
    append(all.slope, own.slope);
    all.shift = own.shift;
  }
  return all;
}

// The points, if a pressure is among the quantities
Points2 pressure_points(const Case& data) {
  const bool wanted =
      !std::all_of(data.quantities.begin(), data.quantities.end(), response::is_structural);
  Points2 points(2, wanted ? static_cast<Index>(data.points.size()) : 0);
  for (Index i = 0; i < points.cols(); ++i)
    points.col(i) = data.points[static_cast<std::size_t>(i)].position;
  return points;
}

// One that the seas hold [rad]
double checked_heading(const Case& data) {
  const double degrees =
      data.seas.empty() ? data.heading_deg.front() : data.seas.front().mean_heading_deg.front();
  return degrees * std::numbers::pi / 180.0;
}

}  // namespace

SeaFluid::SeaFluid(const Case& data, const PlateModel& plate, const FluidModel& fluid)
    : data_(data),
      plate_(plate),
      fluid_(fluid),
      influence_(influences(data, plate, fluid)),
      points_(pressure_points(data)),
      modes_(plate.modes.count()),
      section_forces_(influence_.constant.cols()),
      pressures_(points_.cols()) {}

FluidSample SeaFluid::solve(double omega) const {
  const double nu = wave::deep_wavenumber(omega, data_.water);
  const green::GreenTable green(green::GreenFunction(nu, data_.water.depth), fluid_.reach);
  const auto pressure_operator = make_operator(data_, fluid_, green);
  MatXd deflection(fluid_.deflection.rows(), modes_ + section_forces_);
  deflection << fluid_.deflection, influence_.at(omega);
  hydro::Radiation radiation =
      hydro::solve_radiation(*pressure_operator, deflection, fluid_.surface_mass, omega,
                             data_.water, residual_limit(data_, fluid_));
  FluidSample sample{.omega = omega,
                     .pressure = std::move(radiation.pressure),
                     .fluid_matrix = std::move(radiation.fluid_matrix),
                     .solved = {}};
  sample.solved.report.omega = omega;
  sample.solved.report.method = pressure_operator->method();
  judge(green, radiation, sample);
  if (pressures_ > 0) add_point_pressures(*pressure_operator, green, sample);
  return sample;
}

// The modes alone: they are what the results are made of
void SeaFluid::judge(const green::GreenTable& green, const hydro::Radiation& radiation,
                     FluidSample& sample) const {
  hydro::Radiation of_modes;
  of_modes.fluid_matrix = sample.fluid_matrix.topLeftCorner(modes_, modes_);
  of_modes.added_mass = radiation.added_mass.topLeftCorner(modes_, modes_);
  of_modes.damping = radiation.damping.topLeftCorner(modes_, modes_);
  of_modes.true_residual = radiation.true_residual;
  of_modes.work = radiation.work;
  const auto pressure = sample.pressure.leftCols(modes_);
  FrequencyReport& report = sample.solved.report;
  judge_radiation(data_, fluid_, green, of_modes, pressure, report);
  const MatXcd force = -hydro::full_circle_transform(fluid_.integrals.mesh(),
                                                     wave::wavenumber(sample.omega, data_.water),
                                                     kProbeHeadings, pressure);
  const MatXcd amplitudes = coupling::modal_amplitudes(plate_.modes, data_.plate.loss_factor,
                                                       sample.omega, of_modes.fluid_matrix, force);
  report.mode_change = change_by_modes(data_, plate_, fluid_, sample.omega, of_modes.fluid_matrix,
                                       force, amplitudes);
  sample.solved.response = amplitudes.norm();
}

// Their influences as further columns, and what they are worth
void SeaFluid::add_point_pressures(const bem::PressureOperator& pressure_operator,
                                   const green::GreenTable& green, FluidSample& sample) const {
  const double wavenumber = wave::wavenumber(sample.omega, data_.water);
  const double limit = residual_limit(data_, fluid_);
  const MatXcd influence = hydro::wave_pressure_influence(
      pressure_operator, fluid_.integrals, green, fluid_.surface_mass, points_, data_.water, limit);

  // Hold one heading against its diffraction problem
  const double weight = data_.water.density * data_.water.gravity;
  const std::vector<double> heading = {checked_heading(data_)};
  const mesh::Q8Mesh& mesh = fluid_.integrals.mesh();
  const VecXcd own = weight * hydro::incident_elevation(points_, wavenumber, heading) -
                     influence.transpose() * hydro::wave_loads(mesh, wavenumber, heading);
  const VecXcd direct =
      fluid_.at_points.cast<Complex>() *
      hydro::solve_diffraction(pressure_operator,
                               hydro::incident_elevation(mesh.nodes(), wavenumber, heading),
                               data_.water, limit);
  sample.solved.pressure_error =
      (own - direct).cwiseAbs().maxCoeff() / direct.cwiseAbs().maxCoeff();
  sample.pressure.conservativeResize(Eigen::NoChange, state_size());
  sample.pressure.rightCols(pressures_) = influence;
}

MatXcd SeaFluid::states(const FluidSample& sample, int headings, const VecXd& amplitude) const {
  const double wavenumber = wave::wavenumber(sample.omega, data_.water);
  const bool uniform = amplitude.size() == 0;
  const MatXcd force = -hydro::full_circle_transform(
      fluid_.integrals.mesh(), wavenumber, headings,
      uniform ? sample.pressure : amplitude.cast<Complex>().asDiagonal() * sample.pressure);
  MatXcd state(state_size(), headings);
  state.topRows(modes_) = coupling::modal_amplitudes(
      plate_.modes, data_.plate.loss_factor, sample.omega,
      sample.fluid_matrix.topLeftCorner(modes_, modes_), force.topRows(modes_));

  // What the modes leave out (E.12); it has no loss, which the observing rows put in
  state.middleRows(modes_, section_forces_) =
      (force.middleRows(modes_, section_forces_) +
       sample.fluid_matrix.bottomLeftCorner(section_forces_, modes_) * state.topRows(modes_)) /
      Complex(1.0, -data_.plate.loss_factor);
  if (pressures_ == 0) return state;

  // Pressure of the wave on the plate held fixed, and of its motion (R.4)
  const double weight = data_.water.density * data_.water.gravity;
  const MatXcd moving = fluid_.at_points.cast<Complex>() * sample.pressure.leftCols(modes_);
  MatXcd elevation = hydro::incident_elevation(points_, wavenumber, hydro::full_circle(headings));
  if (!uniform) elevation = (fluid_.at_points * amplitude).cast<Complex>().asDiagonal() * elevation;
  state.bottomRows(pressures_) =
      weight * elevation + force.bottomRows(pressures_) + moving * state.topRows(modes_);
  return state;
}

}  // namespace floe
