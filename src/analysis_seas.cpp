#include "analysis_stages.hpp"
#include "fluid_march.hpp"

#include <floe/coupling/modal_equation.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/response/pseudo_excitation.hpp>
#include <floe/wave/dispersion.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace floe {
namespace {

using response::Quantity;

constexpr double kFirstStep = 0.04;   // [rad/s], for 300 m of length
constexpr double kFinestStep = 0.01;  // of the spectra, for 300 m
constexpr double kReferenceLength = 300.0;
constexpr int kProbeHeadings = 24;

double degrees(double angle) { return angle * std::numbers::pi / 180.0; }

// The quantities that follow from the displacement, in rows that observe the modes at the points
struct Observed {
  std::vector<std::size_t> quantity;
  std::vector<int> derivative;  // in time
  MatXd rows;
};

int time_derivative(Quantity quantity) {
  if (quantity == Quantity::kVelocity) return 1;
  return quantity == Quantity::kAcceleration ? 2 : 0;
}

Observed observe(const Case& data, const PlateModel& plate) {
  const Index modes = plate.modes.count(), points = static_cast<Index>(data.points.size());
  const MatXcd unit = MatXcd::Identity(modes, modes);
  Observed observed;
  observed.rows.resize(0, modes);
  for (std::size_t q = 0; q < data.quantities.size(); ++q) {
    const Quantity quantity = data.quantities[q];
    if (!response::is_structural(quantity)) continue;
    const int derivative = time_derivative(quantity);
    // NOTE: only magnitudes matter: of 1 - iη the modulus, of -iω the power of ω
    const double loss =
        response::is_section_force(quantity) ? std::hypot(1.0, data.plate.loss_factor) : 1.0;
    const MatXd rows =
        plate.points.evaluate(derivative > 0 ? Quantity::kDeflection : quantity, 1.0, unit).real();
    observed.rows.conservativeResize(observed.rows.rows() + points, Eigen::NoChange);
    observed.rows.bottomRows(points) = loss * rows;
    observed.quantity.push_back(q);
    observed.derivative.push_back(derivative);
  }
  return observed;
}

// One sea from one mean heading while it is integrated
struct SeaSum {
  const wave::SeaState* sea;
  double mean_heading_deg;
  response::DirectionGrid grid;
  std::vector<Index> heading;  // of the grid, in the list of all headings
  response::PseudoExcitation response;
};

// All headings that any sea needs, each once
struct SeaSums {
  std::vector<double> heading;  // [rad]
  std::vector<SeaSum> sums;
};

SeaSums begin_sums(const Case& data, const FluidModel& fluid, double highest, const MatXd& rows) {
  const mesh::Q8Mesh& mesh = fluid.integrals.mesh();
  const double radius = 0.5 * (mesh.upper() - mesh.lower()).norm();
  const double k = wave::wavenumber(highest, data.water);
  const int least = static_cast<int>(std::ceil(2.0 * k * radius)) + 20;
  SeaSums all;
  std::map<long long, Index> known;  // by nanoradian on the circle
  for (const wave::SeaState& sea : data.seas)
    for (const double mean : sea.mean_heading_deg) {
      SeaSum sum{&sea,
                 mean,
                 response::direction_grid(sea.spreading, degrees(mean), least),
                 {},
                 response::PseudoExcitation(rows)};
      for (const double heading : sum.grid.heading) {
        const double turn = std::remainder(heading, 2.0 * std::numbers::pi);
        const auto [at, fresh] =
            known.emplace(std::llround(1e9 * turn), static_cast<Index>(all.heading.size()));
        if (fresh) all.heading.push_back(heading);
        sum.heading.push_back(at->second);
      }
      all.sums.push_back(std::move(sum));
    }
  return all;
}

// Equidistant, even in number of steps, fine enough for every sea's spectrum: its own m0 over the
// band comes out to a tenth of the tolerance
std::vector<double> fine_frequencies(const Case& data, const SeaBand& band, double length) {
  const double step = kFinestStep * std::min(1.0, kReferenceLength / length);
  int count = 2 * static_cast<int>(std::ceil(0.5 * (band.to - band.from) / step));
  const auto grid_of = [&](int steps) {
    std::vector<double> omega;
    for (int i = 0; i <= steps; ++i) omega.push_back(band.from + (band.to - band.from) * i / steps);
    return omega;
  };
  for (int doubling = 0; doubling < 8; ++doubling, count *= 2) {
    const std::vector<double> omega = grid_of(count), weight = response::trapezoid_weights(omega);
    const bool good = std::all_of(data.seas.begin(), data.seas.end(), [&](const auto& sea) {
      double sum = 0.0;
      for (std::size_t i = 0; i < omega.size(); ++i) sum += weight[i] * sea.spectrum(omega[i]);
      return std::abs(sum - sea.spectrum.variance(band.from, band.to)) <=
             0.1 * data.sea_grid.tolerance * sea.spectrum.m0();
    });
    if (good) return omega;
  }
  return grid_of(count / 2);
}

// ξ of all headings from what is known of the fluid
MatXcd amplitudes(const Case& data, const PlateModel& plate, const FluidModel& fluid,
                  const FluidSample& sample, const std::vector<double>& heading) {
  const double k = wave::wavenumber(sample.omega, data.water);
  const MatXcd force = hydro::exciting_forces(
      sample.pressure, hydro::wave_loads(fluid.integrals.mesh(), k, heading));
  return coupling::modal_amplitudes(plate.modes, data.plate.loss_factor, sample.omega,
                                    sample.fluid_matrix, force);
}

FluidSample solve_sample(const Case& data, const FluidModel& fluid, double omega) {
  const double nu = wave::deep_wavenumber(omega, data.water);
  const green::GreenTable green(green::GreenFunction(nu, data.water.depth), fluid.reach);
  const auto pressure_operator = make_operator(data, fluid, green);
  hydro::Radiation radiation =
      hydro::solve_radiation(*pressure_operator, fluid.deflection, fluid.surface_mass, omega,
                             data.water, residual_limit(data, fluid));
  return {omega, std::move(radiation.pressure), std::move(radiation.fluid_matrix)};
}

// Relative difference of the responses to two candidates, weighted by the square root of the waves'
// energy there against the peak: what has no waves needs no accuracy
FluidMarch::Difference response_difference(const Case& data, const PlateModel& plate,
                                           const FluidModel& fluid, const SeaBand& band) {
  std::vector<double> peak;
  for (const wave::SeaState& sea : data.seas) {
    double largest = 0.0;
    for (int i = 0; i <= 2000; ++i)
      largest = std::max(largest, sea.spectrum(band.from + (band.to - band.from) * i / 2000));
    peak.push_back(largest);
  }
  return [=, &data, &plate, &fluid](const FluidSample& a, const FluidSample& b) {
    double energy = 0.0;
    for (std::size_t s = 0; s < data.seas.size(); ++s)
      if (peak[s] > 0.0) energy = std::max(energy, data.seas[s].spectrum(a.omega) / peak[s]);
    const std::vector<double> heading = hydro::full_circle(kProbeHeadings);
    const MatXcd one = amplitudes(data, plate, fluid, a, heading);
    const MatXcd other = amplitudes(data, plate, fluid, b, heading);
    return std::sqrt(energy) * (one - other).norm() / one.norm();
  };
}

// Moments, spectra and deviations of one sum
SeaResult finish_sum(const SeaSum& sum, const SeaBand& band, const Observed& observed,
                     const PlateModel& plate) {
  SeaResult result;
  result.sea = sum.sea->name;
  result.mean_heading_deg = sum.mean_heading_deg;
  result.omega = sum.response.omega();
  result.quantity = observed.quantity;
  const Index count = static_cast<Index>(observed.quantity.size());
  const Index points = count > 0 ? observed.rows.rows() / count : 0;
  const MatXd spectra = sum.response.spectra();
  const std::vector<double> weight = response::trapezoid_weights(result.omega);
  double coarse = 0.0, fine = 0.0;
  for (Index q = 0; q < count; ++q) {
    MatXd own = spectra.middleRows(q * points, points);
    MatXd moments = MatXd::Zero(points, 4);
    for (Index i = 0; i < own.cols(); ++i) {
      const double omega = result.omega[static_cast<std::size_t>(i)];
      own.col(i) *= std::pow(omega, 2 * observed.derivative[static_cast<std::size_t>(q)]);
      for (Index m = 0; m < 4; ++m)
        moments.col(m) += weight[static_cast<std::size_t>(i)] *
                          std::pow(omega, response::PseudoExcitation::kOrders[m]) * own.col(i);
    }
    // Every other frequency with twice the step: the ends are among them
    for (Index i = 0; q == 0 && i < own.cols(); i += 2) {
      const bool end = i == 0 || i + 1 == own.cols();
      coarse += (end ? 1.0 : 2.0) * (result.omega[1] - result.omega[0]) * own.col(i).sum();
    }
    if (q == 0) fine = moments.col(0).sum();
    result.spectra.push_back(std::move(own));
    result.moments.push_back(std::move(moments));
  }
  result.grid_error = fine > 0.0 ? std::abs(coarse - fine) / fine : 0.0;

  const MatXcd& covariance = sum.response.modal_covariance(0);
  const Index modes = plate.modes.count();
  const MatXd stations =
      plate.lines.evaluate(Quantity::kDeflection, 1.0, MatXcd::Identity(modes, modes)).real();
  result.line_deviation = response::standard_deviation(stations, covariance);
  result.node_deviation = response::standard_deviation(
      plate.modes.shape(Eigen::seq(0, Eigen::last, 3), Eigen::all), covariance);
  result.share_outside =
      1.0 - sum.sea->spectrum.variance(band.from, band.to) / sum.sea->spectrum.m0();
  return result;
}

}  // namespace

std::vector<SeaResult> solve_seas(const Case& data, const SeaBand& band, const PlateModel& plate,
                                  const FluidModel& fluid, StageClock& clock, Log& log) {
  if (data.seas.empty()) return {};
  const Observed observed = observe(data, plate);
  SeaSums all = begin_sums(data, fluid, band.to, observed.rows);
  const mesh::Q8Mesh& mesh = fluid.integrals.mesh();
  const double length = std::max(kReferenceLength / 10.0, mesh.size());
  const std::vector<double> omega = fine_frequencies(data, band, length);
  const std::vector<double> weight = response::trapezoid_weights(omega);

  // Solve as few frequencies as the tolerance needs, tell the fluid in between
  const auto solve = [&](double at) {
    return clock.time("seas: radiation", [&] { return solve_sample(data, fluid, at); });
  };
  FluidMarch march(band.from, band.to, kFirstStep * kReferenceLength / length,
                   data.sea_grid.tolerance, solve, response_difference(data, plate, fluid, band));
  for (std::size_t i = 0; i < omega.size(); ++i) {
    log.progress(static_cast<double>(i) / static_cast<double>(omega.size()),
                 fmt::format("seas, {:.3f} rad/s", omega[i]));
    const FluidSample sample = march.at(omega[i]);
    clock.time("seas: response", [&] {
      const MatXcd response = amplitudes(data, plate, fluid, sample, all.heading);
      for (SeaSum& sum : all.sums)
        sum.response.add(omega[i], weight[i],
                         response::pseudo_amplitudes(response(Eigen::all, sum.heading),
                                                     sum.sea->spectrum(omega[i]), sum.grid.weight));
    });
  }

  std::vector<SeaResult> results;
  for (const SeaSum& sum : all.sums) {
    results.push_back(finish_sum(sum, band, observed, plate));
    results.back().interpolation_error = march.largest_error();
    results.back().solved_frequencies = march.solved();
  }
  return results;
}

}  // namespace floe
