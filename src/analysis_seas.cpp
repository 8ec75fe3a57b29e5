#include "analysis_stages.hpp"
#include "fluid_march.hpp"

#include <floe/coupling/modal_equation.hpp>
#include <floe/hydro/surface_integrals.hpp>
#include <floe/sea_statistics.hpp>
#include <floe/wave/dispersion.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace floe {
namespace {

using response::Quantity;

constexpr double kFirstStep = 0.04;   // [rad/s], for 300 m of length
constexpr double kFinestStep = 0.01;  // of the spectra, for 300 m
constexpr double kReferenceLength = 300.0;
constexpr int kProbeHeadings = 24;

int time_derivative(Quantity quantity) {
  if (quantity == Quantity::kVelocity) return 1;
  return quantity == Quantity::kAcceleration ? 2 : 0;
}

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
  for (const Quantity quantity : data.quantities) {
    if (!response::is_section_force(quantity)) continue;
    const auto own = plate.correction->influence(plate.points.section_force(quantity));
    append(all.constant, own.constant);
    append(all.slope, own.slope);
    all.shift = own.shift;
  }
  return all;
}

// The quantities that follow from the displacement, in rows that observe states at the points
SeaObservation observe(const Case& data, const PlateModel& plate, const FluidModel& fluid,
                       Index influence_count, Log& log) {
  const Index modes = plate.modes.count(), points = static_cast<Index>(data.points.size());
  const MatXcd unit = MatXcd::Identity(modes, modes);
  SeaObservation observed;
  observed.points.resize(0, modes + influence_count);
  Index influence = modes;
  for (std::size_t q = 0; q < data.quantities.size(); ++q) {
    const Quantity quantity = data.quantities[q];
    if (!response::is_structural(quantity)) {
      log.notice(fmt::format("{} is left out of the statistics of seas", response::name(quantity)));
      continue;
    }
    const int derivative = time_derivative(quantity);
    MatXd rows = MatXd::Zero(points, observed.points.cols());
    rows.leftCols(modes) =
        plate.points.evaluate(derivative > 0 ? Quantity::kDeflection : quantity, 1.0, unit).real();
    if (response::is_section_force(quantity)) {
      rows.middleCols(influence, points).setIdentity();
      influence += points;
      // NOTE: only magnitudes matter: of the factor 1 - iη its modulus
      rows *= std::hypot(1.0, data.plate.loss_factor);
    }
    observed.points.conservativeResize(observed.points.rows() + points, Eigen::NoChange);
    observed.points.bottomRows(points) = rows;
    observed.quantity.push_back(q);
    observed.derivative.push_back(derivative);
  }
  observed.lines = plate.lines.evaluate(Quantity::kDeflection, 1.0, unit).real();
  observed.nodes = fluid.deflection;
  return observed;
}

// Headings on the full circle that resolve a response at the highest frequency, in steps that
// divide 15°
int circle_headings(const Case& data, const mesh::Q8Mesh& mesh, double highest) {
  const double radius = 0.5 * (mesh.upper() - mesh.lower()).norm();
  const double least = 2.0 * wave::wavenumber(highest, data.water) * radius + 20.0;
  return 24 * static_cast<int>(std::ceil(least / 24.0));
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
      for (std::size_t i = 0; i < omega.size(); ++i) sum += weight[i] * sea.density(omega[i]);
      return std::abs(sum - sea.variance(band.from, band.to)) <=
             0.1 * data.sea_grid.tolerance * sea.m0();
    });
    if (good) return omega;
  }
  return grid_of(count / 2);
}

FluidSample solve_sample(const Case& data, const FluidModel& fluid,
                         const plate::StaticCorrection::Influence& influence, double omega) {
  const double nu = wave::deep_wavenumber(omega, data.water);
  const green::GreenTable green(green::GreenFunction(nu, data.water.depth), fluid.reach);
  const auto pressure_operator = make_operator(data, fluid, green);
  MatXd deflection(fluid.deflection.rows(), fluid.deflection.cols() + influence.constant.cols());
  deflection << fluid.deflection, influence.at(omega);
  hydro::Radiation radiation =
      hydro::solve_radiation(*pressure_operator, deflection, fluid.surface_mass, omega, data.water,
                             residual_limit(data, fluid));
  return {omega, std::move(radiation.pressure), std::move(radiation.fluid_matrix)};
}

// States of the waves from all directions, from what is known of the fluid; `pressure` is that of
// the sample, times the amplitude of the waves where it is not 1 everywhere
MatXcd states(const Case& data, const PlateModel& plate, const FluidModel& fluid,
              const FluidSample& sample, const MatXcd& pressure, int headings) {
  const Index modes = plate.modes.count(), others = sample.pressure.cols() - modes;
  const MatXcd force = -hydro::full_circle_transform(
      fluid.integrals.mesh(), wave::wavenumber(sample.omega, data.water), headings, pressure);
  MatXcd state(modes + others, headings);
  state.topRows(modes) = coupling::modal_amplitudes(
      plate.modes, data.plate.loss_factor, sample.omega,
      sample.fluid_matrix.topLeftCorner(modes, modes), force.topRows(modes));
  // What the modes leave out (E.12); it has no loss, which the observing rows put in
  state.bottomRows(others) =
      (force.bottomRows(others) +
       sample.fluid_matrix.bottomLeftCorner(others, modes) * state.topRows(modes)) /
      Complex(1.0, -data.plate.loss_factor);
  return state;
}

// The states of one frequency: of waves of one metre everywhere, and of those of each zone (E.25)
SeaTransfer transfer_of(const Case& data, const PlateModel& plate, const FluidModel& fluid,
                        const FluidSample& sample, int headings, const MatXd& zone_amplitudes) {
  SeaTransfer transfer{sample.omega, states(data, plate, fluid, sample, sample.pressure, headings)};
  for (Index z = 0; z < zone_amplitudes.cols(); ++z)
    transfer.zone_states.push_back(
        states(data, plate, fluid, sample,
               zone_amplitudes.col(z).cast<Complex>().asDiagonal() * sample.pressure, headings));
  return transfer;
}

// How much the responses to two candidates differ, for each quantity and the deflection as a whole
// relative to the largest response so far, both in the sea: what neither wave nor plate has energy
// in needs no accuracy
class ResponseDifference {
 public:
  ResponseDifference(const Case& data, const PlateModel& plate, const FluidModel& fluid,
                     const SeaObservation& observed)
      : data_(data),
        plate_(plate),
        fluid_(fluid),
        observed_(observed),
        largest_(observed.quantity.size() + 1, 0.0) {}

  double operator()(const FluidSample& a, const FluidSample& b) {
    const MatXcd one = states(data_, plate_, fluid_, a, a.pressure, kProbeHeadings);
    const MatXcd other = states(data_, plate_, fluid_, b, b.pressure, kProbeHeadings);
    const Index modes = plate_.modes.count(), points = static_cast<Index>(data_.points.size());
    const double wave = std::sqrt(density(a.omega));
    double worst = compare(0, wave, one.topRows(modes), other.topRows(modes));
    if (points == 0) return worst;
    const MatXcd seen = observed_.points.cast<Complex>() * one;
    const MatXcd seen_other = observed_.points.cast<Complex>() * other;
    for (std::size_t q = 0; q < observed_.quantity.size(); ++q) {
      const Index first = static_cast<Index>(q) * points;
      const double scale = wave * std::pow(a.omega, observed_.derivative[q]);
      worst = std::max(worst, compare(q + 1, scale, seen.middleRows(first, points),
                                      seen_other.middleRows(first, points)));
    }
    return worst;
  }

 private:
  double density(double omega) const {
    double largest = data_.seas.empty() ? 1.0 : 0.0;
    for (const wave::SeaState& sea : data_.seas)
      largest = std::max(largest, sea.density(omega) / sea.m0());
    return largest;
  }

  double compare(std::size_t place, double scale, const Eigen::Ref<const MatXcd>& one,
                 const Eigen::Ref<const MatXcd>& other) {
    largest_[place] = std::max(largest_[place], scale * one.norm());
    return largest_[place] > 0.0 ? scale * (one - other).norm() / largest_[place] : 0.0;
  }

  const Case& data_;  // borrowed, as all
  const PlateModel& plate_;
  const FluidModel& fluid_;
  const SeaObservation& observed_;
  std::vector<double> largest_;
};

}  // namespace

void solve_seas(const Case& data, const SeaBand& band, const PlateModel& plate,
                const FluidModel& fluid, StageClock& clock, Log& log, Store& store) {
  // Prepare what is observed, from where and at which frequencies
  const mesh::Q8Mesh& mesh = fluid.integrals.mesh();
  const double length = std::max(kReferenceLength / 10.0, mesh.size());
  const plate::StaticCorrection::Influence influence =
      clock.time("seas: influences", [&] { return influences(data, plate, fluid); });
  const SeaObservation observation = observe(data, plate, fluid, influence.constant.cols(), log);
  const MatXd zones = all_zone_amplitudes(data.seas, mesh);
  SeaGridReport grid{fine_frequencies(data, band, length), circle_headings(data, mesh, band.to)};
  SeaStatistics statistics(data.seas, observation, grid.omega, grid.headings);
  store.begin_seas(observation, grid);

  // Solve as few frequencies as the tolerance needs, tell the fluid in between
  FluidMarch march(
      band.from, band.to, kFirstStep * kReferenceLength / length, data.sea_grid.tolerance,
      [&](double omega) {
        return clock.time("seas: radiation",
                          [&] { return solve_sample(data, fluid, influence, omega); });
      },
      ResponseDifference(data, plate, fluid, observation));
  for (std::size_t i = 0; i < grid.omega.size(); ++i) {
    log.progress(static_cast<double>(i) / static_cast<double>(grid.omega.size()),
                 fmt::format("seas, {:.3f} rad/s", grid.omega[i]));
    const FluidSample sample = march.at(grid.omega[i]);
    clock.time("seas: response", [&] {
      const SeaTransfer transfer = transfer_of(data, plate, fluid, sample, grid.headings, zones);
      store.sea_transfer(transfer);
      statistics.add(transfer);
    });
  }

  // Tell the statistics, and how they came about
  grid.interpolation_error = march.largest_error();
  grid.solved_frequencies = march.solved();
  for (const SeaResult& result : statistics.results()) store.sea(result);
  store.end_seas(grid);
}

void repeat_seas(const Case& data, const SeaGridReport& grid, Store& store) {
  const SeaObservation observation = store.known_observation();
  SeaStatistics statistics(data.seas, observation, grid.omega, grid.headings);
  store.begin_seas(observation, grid);
  for (std::size_t i = 0; i < grid.omega.size(); ++i) {
    const SeaTransfer transfer = store.known_transfer(i);
    store.sea_transfer(transfer);
    statistics.add(transfer);
  }
  for (const SeaResult& result : statistics.results()) store.sea(result);
  store.end_seas(grid);
}

}  // namespace floe
