#include "finite_checks.hpp"
#include "sea_fluid.hpp"
#include "second_try.hpp"
#include "work_share.hpp"

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

int time_derivative(Quantity quantity) {
  if (quantity == Quantity::kVelocity) return 1;
  return quantity == Quantity::kAcceleration ? 2 : 0;
}

// All quantities at the points, in rows that observe states
SeaObservation observe(const Case& data, const PlateModel& plate, const FluidModel& fluid,
                       const SeaFluid& waves) {
  const Index modes = plate.modes.count(), points = static_cast<Index>(data.points.size());
  const MatXcd unit = MatXcd::Identity(modes, modes);
  SeaObservation observed;
  observed.points =
      MatXd::Zero(points * static_cast<Index>(data.quantities.size()), waves.state_size());
  Index section_force = waves.first_section_force();
  for (std::size_t q = 0; q < data.quantities.size(); ++q) {
    const Quantity quantity = data.quantities[q];
    const int derivative = time_derivative(quantity);
    auto rows = observed.points.middleRows(static_cast<Index>(q) * points, points);
    if (response::is_structural(quantity))
      rows.leftCols(modes) =
          plate.points.evaluate(derivative > 0 ? Quantity::kDeflection : quantity, 1.0, unit)
              .real();
    else
      rows.middleCols(waves.first_pressure(), points)
          .diagonal()
          .setConstant(quantity == Quantity::kPressure
                           ? 1.0
                           : 1.0 / (data.water.density * data.water.gravity));
    if (response::is_section_force(quantity)) {
      rows.middleCols(section_force, points).setIdentity();
      section_force += points;
      // NOTE: of the factor 1 - iη the modulus; the phase stands beside it
      rows *= std::hypot(1.0, data.plate.loss_factor);
    }
    observed.quantity.push_back(q);
    observed.derivative.push_back(derivative);
    observed.phase.push_back(
        response::is_section_force(quantity) ? -std::atan(data.plate.loss_factor) : 0.0);
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
  int count = std::max(4, 2 * static_cast<int>(std::ceil(0.5 * (band.to - band.from) / step)));
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

// The states of one frequency: of waves of one metre everywhere, and of those of each zone (E.25)
SeaTransfer transfer_of(const SeaFluid& waves, const FluidSample& sample, int headings,
                        const MatXd& zone_amplitudes) {
  SeaTransfer transfer{sample.omega, waves.states(sample, headings)};
  for (Index z = 0; z < zone_amplitudes.cols(); ++z)
    transfer.zone_states.push_back(waves.states(sample, headings, zone_amplitudes.col(z)));
  return transfer;
}

// Of the sea that has the largest share of its energy at this frequency, relative to its m0
double largest_density(const Case& data, double omega) {
  double largest = data.seas.empty() ? 1.0 : 0.0;
  for (const wave::SeaState& sea : data.seas)
    largest = std::max(largest, sea.density(omega) / sea.m0());
  return largest;
}

// How much the responses to two candidates differ, for each quantity and the deflection as a whole
// relative to the largest response so far, both in the sea: what neither wave nor plate has energy
// in needs no accuracy
class ResponseDifference {
 public:
  ResponseDifference(const Case& data, const SeaFluid& waves, const SeaObservation& observed)
      : data_(data),
        waves_(waves),
        observed_(observed),
        largest_(observed.quantity.size() + 1, 0.0) {}

  /// One a quantity and the deflection as a whole; all comparisons so far went into it.
  const std::vector<double>& largest() const { return largest_; }
  void remember(const std::vector<double>& largest) {
    if (largest.size() == largest_.size()) largest_ = largest;
  }

  double operator()(const FluidSample& a, const FluidSample& b) {
    const MatXcd one = waves_.states(a, kProbeHeadings);
    const MatXcd other = waves_.states(b, kProbeHeadings);
    const Index modes = observed_.nodes.cols(), points = static_cast<Index>(data_.points.size());
    const double wave = std::sqrt(largest_density(data_, a.omega));
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
  double compare(std::size_t place, double scale, const Eigen::Ref<const MatXcd>& one,
                 const Eigen::Ref<const MatXcd>& other) {
    largest_[place] = std::max(largest_[place], scale * one.norm());
    return largest_[place] > 0.0 ? scale * (one - other).norm() / largest_[place] : 0.0;
  }

  const Case& data_;  // borrowed, as all
  const SeaFluid& waves_;
  const SeaObservation& observed_;
  std::vector<double> largest_;
};

// A march that begins, or goes on where an earlier run left it
FluidMarch begin_march(const FluidMarch::Options& options, const std::optional<SeaMarch>& earlier,
                       Store& store, const FluidMarch::Solve& solve,
                       const FluidMarch::Difference& difference) {
  if (!earlier) return {options, solve, difference};
  std::deque<FluidSample> samples;
  for (const int number : earlier->samples) samples.push_back(*store.known_sea_sample(number));
  return {options, *earlier, std::move(samples), solve, difference};
}

// Hands the spectra of all nodes at one frequency to the store, if they are wanted
NodeSpectrumSink sink_of(const Case& data, std::size_t frequency, Store& store) {
  if (!data.node_spectra) return {};
  return [&store, frequency](std::size_t result, const VecXd& spectrum) {
    store.node_spectrum(result, frequency, spectrum);
  };
}

// What a later run needs to go on at the frequency `next`
SeaMarch state_of(const FluidMarch& march, const ResponseDifference& difference,
                  const std::vector<SolvedSeaFrequency>& solved, std::size_t next) {
  SeaMarch state = march.state();
  state.next = next;
  state.largest_response = difference.largest();
  state.all_solved = solved;
  return state;
}

void warn_of_accuracy(const SeaGridReport& grid, const Case& data, Log& log) {
  constexpr double kPressureTold = 0.1;
  if (grid.interpolation_error > data.sea_grid.tolerance)
    log.warning(
        fmt::format("seas: between solved frequencies the response is known to {:.2g} of its "
                    "largest value (sea_grid.tolerance = {:g}): it has narrower peaks than a case "
                    "of this size should (hold spectra near a peak against regular waves there)",
                    grid.interpolation_error, data.sea_grid.tolerance));
  if (grid.pressure_error > kPressureTold)
    log.warning(
        fmt::format("seas: pressures at the points are known to {:.2g} of the largest at the "
                    "highest frequencies (refine the mesh)",
                    grid.pressure_error));
}

void tell_results(const SeaStatistics& statistics, const SeaGridReport& grid, const Case& data,
                  Log& log, Store& store) {
  warn_of_accuracy(grid, data, log);
  for (const SeaResult& result : statistics.results()) {
    store.sea(result);
    for (const std::string& warning : cut_responses(result, data)) log.warning(warning);
  }
}

}  // namespace

void solve_seas(const Case& data, const SeaBand& band, const PlateModel& plate, FluidModel& fluid,
                StageClock& clock, WorkShare& work, Log& log, Store& store) {
  // Prepare what is observed, from where and at which frequencies
  const mesh::Q8Mesh& mesh = fluid.integrals.mesh();
  const double length = std::max(kReferenceLength / 10.0, mesh.size());
  const SeaFluid waves =
      clock.time("seas: influences", [&] { return SeaFluid(data, plate, fluid); });
  const SeaObservation observation = observe(data, plate, fluid, waves);
  const MatXd zones = all_zone_amplitudes(data.seas, mesh);
  SeaGridReport grid;
  grid.omega = fine_frequencies(data, band, length);
  grid.headings = circle_headings(data, mesh, band.to);
  SeaStatistics statistics(data.seas, observation, grid.omega, grid.headings, data.relations);
  const std::optional<SeaMarch> earlier = store.known_sea_march();
  store.begin_seas(observation, grid);

  // Solve as few frequencies as the tolerance needs
  ResponseDifference difference(data, waves, observation);
  if (earlier) {
    difference.remember(earlier->largest_response);
    grid.solved = earlier->all_solved;
  }
  const auto solve = [&](int number, double omega) {
    if (std::optional<FluidSample> known = store.known_sea_sample(number))
      if (known->omega == omega) {
        grid.solved.push_back(known->solved);
        return std::move(*known);
      }
    FluidSample sample = clock.time("seas: radiation", [&] {
      return solve_or_retry(data, fluid, omega, log, [&] { return waves.solve(omega); });
    });
    sample.solved.response *= std::sqrt(largest_density(data, omega));
    grid.solved.push_back(sample.solved);
    store.sea_sample(number, sample);
    return sample;
  };
  FluidMarch march =
      begin_march({.omega = grid.omega,
                   .first_step = kFirstStep * kReferenceLength / length,
                   .tolerance = data.sea_grid.tolerance},
                  earlier, store, solve,
                  [&](const FluidSample& a, const FluidSample& b) { return difference(a, b); });

  // Tell the fluid in between
  const std::size_t first = earlier ? earlier->next : 0;
  int kept = earlier ? earlier->solved : 0;  // samples up to the last state that was stored
  for (std::size_t i = 0; i < grid.omega.size(); ++i) {
    work.seas(i, first, grid.omega.size());
    log.progress(work.share(), fmt::format("seas, {:.3f} rad/s", grid.omega[i]));
    if (i < first) {
      const SeaTransfer transfer = store.known_transfer(i);
      store.sea_transfer(transfer);
      statistics.add(transfer, sink_of(data, i, store));
      continue;
    }
    const FluidSample sample = march.at(grid.omega[i]);
    clock.time("seas: response", [&] {
      const SeaTransfer transfer = transfer_of(waves, sample, grid.headings, zones);
      require_finite(transfer);
      store.sea_transfer(transfer);
      statistics.add(transfer, sink_of(data, i, store));
    });
    if (march.solved() == kept) continue;
    store.sea_march(state_of(march, difference, grid.solved, i + 1));
    kept = march.solved();
  }

  // Tell the statistics, and how they came about
  grid.interpolation_error = march.largest_error();
  grid.solved_frequencies = march.solved();
  for (const SolvedSeaFrequency& one : grid.solved)
    grid.pressure_error = std::max(grid.pressure_error, one.pressure_error);
  tell_results(statistics, grid, data, log, store);
  store.end_seas(grid);
}

void repeat_seas(const Case& data, const SeaGridReport& grid, Log& log, Store& store) {
  const SeaObservation observation = store.known_observation();
  SeaStatistics statistics(data.seas, observation, grid.omega, grid.headings, data.relations);
  store.begin_seas(observation, grid);
  for (std::size_t i = 0; i < grid.omega.size(); ++i) {
    const SeaTransfer transfer = store.known_transfer(i);
    store.sea_transfer(transfer);
    statistics.add(transfer, sink_of(data, i, store));
  }
  tell_results(statistics, grid, data, log, store);
  store.end_seas(grid);
}

}  // namespace floe
